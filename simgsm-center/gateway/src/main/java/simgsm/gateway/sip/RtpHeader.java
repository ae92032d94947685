package simgsm.gateway.sip;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;

/**
 * The header of an RTP packet (RFC 3550, 5.1).
 *
 * @param sequence 0 to 65535
 * @param timestamp 32 bits, in samples
 * @param source SSRC, 32 bits
 * @param from first octet of the payload
 * @param to end of the payload, exclusive
 */
record RtpHeader(int payloadType, int sequence, int timestamp, int source, int from, int to) {
    private static final int OCTETS = 12;
    private static final int VERSION_MASK = 0xc0;
    private static final int VERSION_2 = 0x80;
    private static final int PADDING = 0x20;
    private static final int EXTENSION = 0x10;
    /** Types 200 to 207 of RTCP on the same port (RFC 5761, 4). */
    private static final int FIRST_RTCP = 72;

    private static final int LAST_RTCP = 79;

    /** Empty for anything but RTP, such as STUN and RTCP. */
    static Optional<RtpHeader> parse(byte[] octets) {
        if (octets.length < OCTETS || (octets[0] & VERSION_MASK) != VERSION_2) {
            return Optional.empty();
        }
        ByteBuffer in = ByteBuffer.wrap(octets);
        int flags = in.get();
        int type = in.get() & 0x7f;
        int sequence = in.getShort() & 0xffff;
        int timestamp = in.getInt();
        int source = in.getInt();
        int from = OCTETS + 4 * (flags & 0x0f);
        if ((flags & EXTENSION) != 0 && from + 4 <= octets.length) {
            from += 4 + 4 * (in.getShort(from + 2) & 0xffff);
        }
        int to = octets.length - ((flags & PADDING) != 0 ? octets[octets.length - 1] & 0xff : 0);
        boolean isRtcp = type >= FIRST_RTCP && type <= LAST_RTCP;
        return isRtcp || from > to
                ? Optional.empty()
                : Optional.of(new RtpHeader(type, sequence, timestamp, source, from, to));
    }

    byte[] payload(byte[] octets) {
        return Arrays.copyOfRange(octets, from, to);
    }

    /** A packet without contributing sources. */
    static byte[] packet(int payloadType, int sequence, int timestamp, int source, byte[] payload) {
        return ByteBuffer.allocate(OCTETS + payload.length)
                .put((byte) VERSION_2)
                .put((byte) payloadType)
                .putShort((short) sequence)
                .putInt(timestamp)
                .putInt(source)
                .put(payload)
                .array();
    }
}
