package simgsm.cells.tower;

import java.util.Optional;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.Cause;
import simgsm.octets.OctetString;
import simgsm.octets.Octets;

/** Answers to messages of the controller that cannot be handled (TS 48.058, 7). */
final class RslErrors {
    /** Radio channel already activated. */
    static final int CHANNEL_ACTIVATED = 0x50;

    /** Most octets of a message that an ERROR REPORT repeats. */
    private static final int MOST_REPEATED = 200;

    private RslErrors() {}

    /** The ERROR REPORT for a message; empty for an ERROR REPORT, and for one without a type. */
    static Optional<RslPdu> report(Cause cause, byte[] message) {
        if (message.length < 2 || message[1] == RslType.ERROR_REPORT.code()) {
            return Optional.empty();
        }
        byte[] repeated = Octets.range(message, 0, Math.min(message.length, MOST_REPEATED));
        return Optional.of(RslPdu.of(RslType.ERROR_REPORT)
                .with(RslElement.CAUSE, cause(cause))
                .with(RslElement.MESSAGE_IDENTIFIER, message[1])
                .with(RslElement.ERRONEOUS_MESSAGE, OctetString.of(repeated)));
    }

    /** The cause in RSL (TS 48.058, 9.3.26); a service is always a ciphering algorithm. */
    static int cause(Cause cause) {
        return switch (cause) {
            case SERVICE_NOT_IMPLEMENTED -> 0x40;
            case MESSAGE_TYPE_NON_EXISTENT -> 0x61;
            case MESSAGE_NOT_COMPATIBLE_WITH_STATE -> 0x62;
            case INVALID_MANDATORY_INFORMATION -> 0x64;
            default -> 0x6f;
        };
    }
}
