package simgsm.air;

import java.util.Optional;

/**
 * The RP layer of short messages (TS 24.011, 7.3), carried in CP-DATA. The codec tells the two directions apart.
 */
public sealed interface RelayMessage {
    /** RP message reference, 0 to 255. */
    int reference();

    /**
     * A transfer unit on its way.
     *
     * @param serviceCenter the SMSC's address: RP-DA uplink, RP-OA downlink
     * @param tpdu SUBMIT uplink, DELIVER or STATUS-REPORT downlink (TS 23.040), at most 232 octets
     */
    record RpData(int reference, Msisdn serviceCenter, OctetString tpdu) implements RelayMessage {}

    /** @param tpdu an optional DELIVER-REPORT or SUBMIT-REPORT */
    record RpAck(int reference, Optional<OctetString> tpdu) implements RelayMessage {}

    record RpError(int reference, RpCause cause) implements RelayMessage {}

    /** The mobile has memory for messages again. */
    record RpSmma(int reference) implements RelayMessage {}
}
