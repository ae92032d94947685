package simgsm.ss;

import java.util.Arrays;
import java.util.Optional;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.ss.Component.Invoke;

/**
 * The operation notifySS in a FACILITY of a call (TS 24.080, 3.6.1: NotifySS-Arg), by an element of its argument and the
 * bits of its value: what the other party (TS 24.083, 2.2.1) or the network (TS 24.082, 1 to 4) has done with the call.
 */
public enum NotifySs {
    /** CallOnHold-Indicator. */
    CALL_ON_HOLD(Tag.CALL_ON_HOLD_INDICATOR, 0xff, 1),
    CALL_RETRIEVED(Tag.CALL_ON_HOLD_INDICATOR, 0xff, 0),
    /** SS-Notification, to the caller. */
    OUTGOING_CALL_FORWARDED(Tag.SS_NOTIFICATION, 0x04, 0x04),
    /** SS-Notification, to the subscriber who has set the forwarding. */
    INCOMING_CALL_FORWARDED(Tag.SS_NOTIFICATION, 0x02, 0x02),
    /** SS-Status, to the subscriber who has set the forwarding and makes a call. */
    FORWARDING_ACTIVE(
            Tag.SS_STATUS,
            ServiceStatus.ACTIVE,
            ServiceStatus.ACTIVE | ServiceStatus.PROVISIONED | ServiceStatus.REGISTERED);

    /** Tags of the argument's elements, all IMPLICIT. */
    private static final class Tag {
        static final int SS_CODE = 0x81;
        static final int SS_STATUS = 0x84;
        static final int SS_NOTIFICATION = 0x85;
        static final int CALL_ON_HOLD_INDICATOR = 0x8f;
    }

    /** SS-Code of call hold (TS 29.002, 17.7.5). */
    private static final int CALL_HOLD = 0x42;

    /** The network expects no answer, so its invocations may have the same identifier. */
    private static final int INVOKE_ID = 1;

    private final int tag;
    private final int mask;
    private final int value;

    NotifySs(int tag, int mask, int value) {
        this.tag = tag;
        this.mask = mask;
        this.value = value;
    }

    /** The facility about a call on hold, or retrieved. */
    public OctetString facility() {
        return facility(CALL_HOLD);
    }

    /** The facility about a forwarding on this condition. */
    public OctetString facility(SsCode condition) {
        return facility(condition.code());
    }

    private OctetString facility(int service) {
        OctetWriter body = BerElement.write(new OctetWriter(), Tag.SS_CODE, service);
        BerElement.write(body, tag, value);
        OctetString argument = BerElement.write(new OctetWriter(), BerElement.SEQUENCE, body.toOctetString())
                .toOctetString();
        return ComponentCodec.encode(new Invoke(INVOKE_ID, SsOperation.NOTIFY_SS, argument));
    }

    /** The notification in a facility; empty for any other or a broken component. */
    public static Optional<NotifySs> of(OctetString facility) {
        try {
            return ComponentCodec.decode(facility) instanceof Invoke invoke && invoke.is(SsOperation.NOTIFY_SS)
                    ? of(invoke)
                    : Optional.empty();
        } catch (ComponentFault | ProtocolViolation broken) {
            return Optional.empty();
        }
    }

    private static Optional<NotifySs> of(Invoke invoke) throws ProtocolViolation {
        MessageReader in = new MessageReader(
                BerElement.read(new MessageReader(invoke.argument()), BerElement.SEQUENCE, "the argument"));
        Optional<NotifySs> found = Optional.empty();
        while (found.isEmpty() && in.hasMore()) {
            BerElement element = BerElement.read(in, "the argument");
            found = Arrays.stream(values()).filter(each -> each.isIn(element)).findFirst();
        }
        return found;
    }

    private boolean isIn(BerElement element) {
        return element.tag() == tag
                && element.content().length() == 1
                && (element.content().octet(0) & mask) == (value & mask);
    }
}
