package simgsm.air;

import java.util.Optional;
import simgsm.octets.OctetString;

/**
 * The RP layer of short messages (TS 24.011, 7.3), carried in CP-DATA. The codec tells the two directions apart.
 */
public sealed interface RelayMessage {
    int MAX_TPDU_LENGTH = 232;

    /** RP message reference, 0 to 255. */
    int reference();

    /** Whether a TPDU may have this many octets. */
    static boolean isTpduLength(int octets) {
        return octets > 0 && octets <= MAX_TPDU_LENGTH;
    }

    private static void checkReference(int reference) {
        if (reference < 0 || reference > 0xff) {
            throw new IllegalArgumentException("RP message reference " + reference + " is not 0 to 255");
        }
    }

    private static void checkTpdu(OctetString tpdu) {
        if (!isTpduLength(tpdu.length())) {
            throw new IllegalArgumentException(
                    "a TPDU of " + tpdu.length() + " octets, 1 to " + MAX_TPDU_LENGTH + " were expected");
        }
    }

    /**
     * A transfer unit on its way.
     *
     * @param serviceCenter the SMSC's address: RP-DA uplink, RP-OA downlink
     * @param tpdu SUBMIT uplink, DELIVER or STATUS-REPORT downlink (TS 23.040), at most 232 octets
     */
    record RpData(int reference, Msisdn serviceCenter, OctetString tpdu) implements RelayMessage {
        public RpData {
            checkReference(reference);
            checkTpdu(tpdu);
        }
    }

    /** @param tpdu an optional DELIVER-REPORT or SUBMIT-REPORT */
    record RpAck(int reference, Optional<OctetString> tpdu) implements RelayMessage {
        public RpAck {
            checkReference(reference);
            tpdu.ifPresent(RelayMessage::checkTpdu);
        }
    }

    record RpError(int reference, RpCause cause) implements RelayMessage {
        public RpError {
            checkReference(reference);
        }
    }

    /** The mobile has memory for messages again. */
    record RpSmma(int reference) implements RelayMessage {
        public RpSmma {
            checkReference(reference);
        }
    }
}
