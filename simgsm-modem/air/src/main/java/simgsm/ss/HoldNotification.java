package simgsm.ss;

import java.util.Optional;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.ss.Component.Invoke;

/**
 * The other party has held or retrieved the call: the operation notifySS in a FACILITY of the call (TS 24.083, 2.2.1;
 * TS 24.080, 3.6.1: NotifySS-Arg).
 */
public final class HoldNotification {
    /** SS-Code of call hold (TS 29.002, 17.7.5). */
    private static final int CALL_HOLD = 0x42;

    /** [1] IMPLICIT SS-Code. */
    private static final int SERVICE = 0x81;
    /** [15] IMPLICIT CallOnHold-Indicator: 0 retrieved, 1 on hold. */
    private static final int INDICATOR = 0x8f;

    /** The network expects no answer, so its invocations may have the same identifier. */
    private static final int INVOKE_ID = 1;

    private HoldNotification() {}

    /** The facility of the message. */
    public static OctetString encode(boolean onHold) {
        OctetWriter body = BerElement.write(new OctetWriter(), SERVICE, CALL_HOLD);
        BerElement.write(body, INDICATOR, onHold ? 1 : 0);
        OctetString argument = BerElement.write(new OctetWriter(), BerElement.SEQUENCE, body.toOctetString())
                .toOctetString();
        return ComponentCodec.encode(new Invoke(INVOKE_ID, SsOperation.NOTIFY_SS, argument));
    }

    /** True if the call is on hold; empty for any other or a broken component. */
    public static Optional<Boolean> decode(OctetString facility) {
        try {
            return ComponentCodec.decode(facility) instanceof Invoke invoke && invoke.is(SsOperation.NOTIFY_SS)
                    ? indicator(invoke.argument())
                    : Optional.empty();
        } catch (ComponentFault | ProtocolViolation broken) {
            return Optional.empty();
        }
    }

    private static Optional<Boolean> indicator(OctetString argument) throws ProtocolViolation {
        MessageReader in =
                new MessageReader(BerElement.read(new MessageReader(argument), BerElement.SEQUENCE, "the argument"));
        while (in.hasMore()) {
            BerElement element = BerElement.read(in, "the argument");
            if (element.tag() == INDICATOR) {
                return Optional.of(element.octet("the indicator") == 1);
            }
        }
        return Optional.empty();
    }
}
