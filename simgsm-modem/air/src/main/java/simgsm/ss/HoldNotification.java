package simgsm.ss;

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

    private static final int OUTGOING_CALL_FORWARDED = 0x04;

    /** The network expects no answer, so its invocations may have the same identifier. */
    private static final int INVOKE_ID = 1;

    private HoldNotification() {}

    /** The facility of the message. */
    public static OctetString encode(boolean onHold) {
        return encode(CALL_HOLD, INDICATOR, onHold ? 1 : 0);
    }

    /** The facility for a caller whose call is forwarded (TS 24.082, 2 to 5). */
    public static OctetString encodeForwarded(SsCode condition) {
        return encode(condition.code(), NOTIFICATION, OUTGOING_CALL_FORWARDED);
    }

    private static OctetString encode(int service, int tag, int value) {
        OctetWriter body = BerElement.write(new OctetWriter(), SERVICE, service);
        BerElement.write(body, tag, value);
        OctetString argument = BerElement.write(new OctetWriter(), BerElement.SEQUENCE, body.toOctetString())
                .toOctetString();
        return ComponentCodec.encode(new Invoke(INVOKE_ID, SsOperation.NOTIFY_SS, argument));
    }

    /** True if the caller is told that the call is forwarded. */
    public static boolean isForwarded(OctetString facility) {
        return element(facility, NOTIFICATION)
                .filter(value -> (value & OUTGOING_CALL_FORWARDED) != 0)
                .isPresent();
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
