package simgsm.air;

import java.util.Optional;
import simgsm.octets.OctetString;

/**
 * The RP layer of short messages (TS 24.011, 7.3), in CP-DATA. The two directions have different message types on the
 * wire.
 */
public sealed interface RelayMessage {
    int MAX_TPDU_LENGTH = 232;

    /** RP message reference, 0 to 255. */
    int reference();

    /** True if a TPDU may have this many octets. */
    static boolean isTpduLength(int octets) {
        return octets > 0 && octets <= MAX_TPDU_LENGTH;
    }

    /**
     * Carries a transfer unit.
     *
     * @param serviceCenter the SMSC's address: RP-DA uplink, RP-OA downlink
     * @param tpdu SUBMIT uplink, DELIVER or STATUS-REPORT downlink (TS 23.040), at most 232 octets
     */
    record RpData(int reference, Msisdn serviceCenter, OctetString tpdu) implements RelayMessage {
        public RpData {
            tpdu.requireLength("TPDU", 1, MAX_TPDU_LENGTH);
        }
    }

    /** @param tpdu an optional DELIVER-REPORT or SUBMIT-REPORT */
    record RpAck(int reference, Optional<OctetString> tpdu) implements RelayMessage {}

    record RpError(int reference, RpCause cause) implements RelayMessage {}

    /** The mobile has memory for messages again. */
    record RpSmma(int reference) implements RelayMessage {}
}
