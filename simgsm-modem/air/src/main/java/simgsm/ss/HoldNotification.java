package simgsm.ss;

import java.util.Arrays;
import java.util.Optional;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.ss.Component.Invoke;

/**
 * The other party has held or retrieved the call, or the call is forwarded: the operation notifySS in a FACILITY of the call (TS 24.083, 2.2.1;
 * TS 24.080, 3.6.1: NotifySS-Arg).
 */
public final class HoldNotification {
    /** SS-Code of call hold (TS 29.002, 17.7.5). */
    private static final int CALL_HOLD = 0x42;

    /** [1] IMPLICIT SS-Code. */
    private static final int SERVICE = 0x81;
    /** [15] IMPLICIT CallOnHold-Indicator: 0 retrieved, 1 on hold. */
    private static final int INDICATOR = 0x8f;
    /** [5] IMPLICIT SS-Notification. */
    private static final int NOTIFICATION = 0x85;

    /** [4] IMPLICIT SS-Status. */
    private static final int STATUS = 0x84;

    /** The network expects no answer, so its invocations may have the same identifier. */
    private static final int INVOKE_ID = 1;

    /** A notification of call forwarding (TS 24.082, 1 to 4), by its argument's tag and a bit of its value. */
    public enum Forwarding {
        /** To the caller. */
        OUTGOING_CALL_FORWARDED(NOTIFICATION, 0x04),
        /** To the subscriber who has set it. */
        INCOMING_CALL_FORWARDED(NOTIFICATION, 0x02),
        /** To the subscriber who has set it and makes a call. */
        ACTIVE(STATUS, ServiceStatus.ACTIVE);

        private final int tag;
        private final int bit;

        Forwarding(int tag, int bit) {
            this.tag = tag;
            this.bit = bit;
        }
    }

    private HoldNotification() {}

    /** The facility of the message. */
    public static OctetString encode(boolean onHold) {
        return encode(CALL_HOLD, INDICATOR, onHold ? 1 : 0);
    }

    /** The facility about a forwarding on this condition. */
    public static OctetString encode(Forwarding what, SsCode condition) {
        int others = what == Forwarding.ACTIVE ? ServiceStatus.PROVISIONED | ServiceStatus.REGISTERED : 0;
        return encode(condition.code(), what.tag, what.bit | others);
    }

    private static OctetString encode(int service, int tag, int value) {
        OctetWriter body = BerElement.write(new OctetWriter(), SERVICE, service);
        BerElement.write(body, tag, value);
        OctetString argument = BerElement.write(new OctetWriter(), BerElement.SEQUENCE, body.toOctetString())
                .toOctetString();
        return ComponentCodec.encode(new Invoke(INVOKE_ID, SsOperation.NOTIFY_SS, argument));
    }

    /** The notification of forwarding in a facility; empty for any other or a broken component. */
    public static Optional<Forwarding> forwarding(OctetString facility) {
        return Arrays.stream(Forwarding.values())
                .filter(each -> element(facility, each.tag)
                        .filter(value -> (value & each.bit) != 0)
                        .isPresent())
                .findFirst();
    }

    /** True if the call is on hold; empty for any other or a broken component. */
    public static Optional<Boolean> decode(OctetString facility) {
        return element(facility, INDICATOR).map(value -> value == 1);
    }

    private static Optional<Integer> element(OctetString facility, int tag) {
        try {
            return ComponentCodec.decode(facility) instanceof Invoke invoke && invoke.is(SsOperation.NOTIFY_SS)
                    ? element(invoke, tag)
                    : Optional.empty();
        } catch (ComponentFault | ProtocolViolation broken) {
            return Optional.empty();
        }
    }

    private static Optional<Integer> element(Invoke invoke, int tag) throws ProtocolViolation {
        MessageReader in = new MessageReader(
                BerElement.read(new MessageReader(invoke.argument()), BerElement.SEQUENCE, "the argument"));
        while (in.hasMore()) {
            BerElement element = BerElement.read(in, "the argument");
            if (element.tag() == tag) {
                return Optional.of(element.octet("the notification"));
            }
        }
        return Optional.empty();
    }
}
