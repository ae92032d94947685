package simgsm.air;

import java.util.Optional;
import simgsm.octets.Bounds;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** Radio resource messages (TS 44.018, 9.1), protocol discriminator 6, of dedicated channels. */
public sealed interface RadioResource extends Layer3Message {
    /** RR cause of normal events (TS 44.018, 10.5.2.31). */
    int NORMAL_EVENT = 0;

    /** Channel mode (TS 44.018, 10.5.2.6): signalling only. */
    int SIGNALLING_ONLY = 0x00;

    /** Channel mode: speech, full rate version 1. */
    int SPEECH_FULL_RATE = 0x01;

    /** The mobile's answer to paging; opens a radio connection for a mobile-terminated call or message. */
    record PagingResponse(int keySequence, MobileIdentity identity) implements RadioResource {}

    /**
     * The description of a cell to find (TS 44.018, 10.5.2.2).
     *
     * @param identityCode base station identity code: network colour code in bits 6-4, base station colour code in
     *     bits 3-1
     * @param frequency ARFCN of the BCCH, 0 to 1023
     */
    record CellDescription(int identityCode, int frequency) {
        public CellDescription {
            Bounds.check("BSIC", identityCode, 0, 63);
            Bounds.check("ARFCN", frequency, 0, 1023);
        }

        /** The two octets. */
        public OctetString encode() {
            return new OctetWriter()
                    .octet(frequency >> 8 << 6 | identityCode)
                    .octet(frequency)
                    .toOctetString();
        }

        /** The description of the next two octets. */
        public static CellDescription read(MessageReader in) throws ProtocolViolation {
            int first = in.octet("cell description");
            return new CellDescription(first & 0x3f, (first & 0xc0) << 2 | in.octet("cell description"));
        }

        /** As "ARFCN 110, BSIC 11". */
        @Override
        public String toString() {
            return "ARFCN " + frequency + ", BSIC " + identityCode;
        }
    }

    /** @param cause RR cause (TS 44.018, 10.5.2.31); 0 is normal event */
    record ChannelRelease(int cause) implements RadioResource {}

    /** @param cause RR cause; 97 message type non-existent */
    record RrStatus(int cause) implements RadioResource {}

    /**
     * Moves the mobile to another channel of its cell.
     *
     * @param powerLevel MS power control level, 0 to 31 (TS 45.005)
     * @param channelMode (TS 44.018, 10.5.2.6); {@link #SPEECH_FULL_RATE}
     */
    record AssignmentCommand(ChannelDescription channel, int powerLevel, int channelMode) implements RadioResource {}

    /** Changes the mode of the mobile's channel. @param mode (TS 44.018, 10.5.2.6) */
    record ChannelModeModify(ChannelDescription channel, int mode) implements RadioResource {}

    /**
     * @param mode used by the mobile from now on: the old one if the requested is unsupported (TS 44.018, 3.4.6.1.3)
     */
    record ChannelModeModifyAcknowledge(ChannelDescription channel, int mode) implements RadioResource {}

    /** @param cause RR cause */
    record AssignmentComplete(int cause) implements RadioResource {}

    /** The mobile has returned to the old channel. @param cause RR cause */
    record AssignmentFailure(int cause) implements RadioResource {}

    /**
     * Moves the mobile to a channel of another cell. The cells are not synchronised: the mobile sends access bursts
     * until it receives PHYSICAL INFORMATION.
     *
     * @param reference 0 to 255, in the access bursts
     * @param powerLevel MS power control level, 0 to 31
     * @param channelMode absent if unchanged
     */
    record HandoverCommand(
            CellDescription cell,
            ChannelDescription channel,
            int reference,
            int powerLevel,
            Optional<Integer> channelMode)
            implements RadioResource {}

    /** The first message on the new channel. @param cause RR cause */
    record HandoverComplete(int cause) implements RadioResource {}

    /** The mobile has returned to the old channel. @param cause RR cause */
    record HandoverFailure(int cause) implements RadioResource {}

    /** Starts or stops ciphering. @param algorithm A5/0 to stop; @param response 1 asks for the IMEISV, 0 does not */
    record CipheringModeCommand(CipherAlgorithm algorithm, int response) implements RadioResource {}

    /** The first ciphered message. @param equipment IMEISV, if the network has asked for it */
    record CipheringModeComplete(Optional<MobileIdentity> equipment) implements RadioResource {}

    record ClassmarkEnquiry() implements RadioResource {}

    /** The capabilities of all terminals. */
    record ClassmarkChange() implements RadioResource {}

    /** Stops the access bursts. @param timingAdvance 0 to 63, in bits of 3.69 us */
    record PhysicalInformation(int timingAdvance) implements RadioResource {}

    /** Sent every 480 ms on the SACCH. */
    record MeasurementReport(MeasurementResults results) implements RadioResource {}
}
