package simgsm.air;

/**
 * One 20 ms speech frame as RTP (RFC 3550), the payload of an {@link IpaFrame#SPEECH} frame.
 *
 * @param payloadType 8 A-law of 160 octets, or 3 GSM 06.10 of 33 octets (RFC 3551)
 * @param sequence 0 to 65535
 * @param timestamp in samples, unsigned 32 bits
 * @param payload not copied, so nobody may change it
 */
public record RtpPacket(int payloadType, int sequence, long timestamp, long source, byte[] payload) {
    public static final int A_LAW = 8;
    public static final int GSM_FULL_RATE = 3;

    public byte[] encode() {
        throw new UnsupportedOperationException();
    }

    public static RtpPacket decode(byte[] octets) throws ProtocolViolation {
        throw new UnsupportedOperationException();
    }
}
