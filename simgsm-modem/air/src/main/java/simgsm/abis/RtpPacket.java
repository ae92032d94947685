package simgsm.abis;

import java.nio.ByteBuffer;
import simgsm.air.Cause;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.Bounds;

/**
 * One 20 ms speech frame as RTP (RFC 3550), the payload of an {@link IpaFrame#SPEECH} frame.
 *
 * @param payloadType 8 A-law of 160 octets, or 3 GSM 06.10 of 33 octets (RFC 3551)
 * @param sequence 0 to 65535
 * @param timestamp in samples, unsigned 32 bits
 * @param source the sender's synchronisation source, unsigned 32 bits
 * @param payload not copied, so it must not change
 */
public record RtpPacket(int payloadType, int sequence, long timestamp, long source, byte[] payload) {
    public static final int A_LAW = 8;
    public static final int GSM_FULL_RATE = 3;

    /** A GSM full rate frame begins with the signature 0xd (RFC 3551, 4.5.8). */
    private static final int SIGNATURE_MASK = 0xf0;

    private static final int GSM_SIGNATURE = 0xd0;
    private static final int HEADER_LENGTH = 12;
    private static final int VERSION_2 = 0x80;
    private static final int PADDING_FLAG = 0x20;
    private static final int EXTENSION_FLAG = 0x10;
    private static final long MAX_UNSIGNED_32 = 0xffff_ffffL;

    public RtpPacket {
        if (payload.length != payloadLength(payloadType)) {
            throw new IllegalArgumentException(
                    "payload type " + payloadType + " does not have " + payload.length + " octets");
        }
        Bounds.check("RTP sequence number", sequence, 0, 0xffff);
        if (timestamp < 0 || timestamp > MAX_UNSIGNED_32 || source < 0 || source > MAX_UNSIGNED_32) {
            throw new IllegalArgumentException("an RTP time stamp or source is not an unsigned 32-bit number");
        }
    }

    /** Octets of a frame of this type; -1 for a type that is not supported. */
    private static int payloadLength(int payloadType) {
        return payloadType == A_LAW ? 160 : payloadType == GSM_FULL_RATE ? 33 : -1;
    }

    /** The packet's octets. */
    public byte[] encode() {
        return ByteBuffer.allocate(HEADER_LENGTH + payload.length)
                .put((byte) VERSION_2)
                .put((byte) payloadType)
                .putShort((short) sequence)
                .putInt((int) timestamp)
                .putInt((int) source)
                .put(payload)
                .array();
    }

    /** The packet of these octets; contributing sources and an extension are skipped. */
    public static RtpPacket decode(byte[] octets) throws ProtocolViolation {
        MessageReader in = new MessageReader(octets);
        int flags = in.octet("RTP header");
        if ((flags & 0xc0) != VERSION_2 || (flags & PADDING_FLAG) != 0) {
            throw new ProtocolViolation(
                    Cause.PROTOCOL_ERROR, "an RTP header of version 2 without padding was expected");
        }
        int payloadType = in.octet("RTP payload type") & 0x7f;
        int sequence = in.twoOctets("RTP sequence number");
        long timestamp = in.fourOctets("RTP time stamp");
        long source = in.fourOctets("RTP source");
        in.part(4 * (flags & 0x0f), "RTP contributing sources");
        if ((flags & EXTENSION_FLAG) != 0) {
            in.twoOctets("RTP extension");
            in.part(4 * in.twoOctets("RTP extension length"), "RTP extension");
        }
        if (in.remaining() != payloadLength(payloadType)) {
            throw new ProtocolViolation(
                    Cause.PROTOCOL_ERROR,
                    "RTP payload type " + payloadType + " with " + in.remaining()
                            + " octets; A-law (8) with 160 or GSM full rate (3) with 33 was expected");
        }
        byte[] payload = in.bytes(in.remaining(), "RTP payload");
        if (payloadType == GSM_FULL_RATE && (payload[0] & SIGNATURE_MASK) != GSM_SIGNATURE) {
            throw new ProtocolViolation(
                    Cause.PROTOCOL_ERROR, "a GSM full rate frame begins with the signature D (RFC 3551, 4.5.8)");
        }
        return new RtpPacket(payloadType, sequence, timestamp, source, payload);
    }
}
