package simrobot.p2os;

import java.nio.ByteOrder;
import simgsm.octets.OctetWriter;

/**
 * The frame of every packet: {@code FA FB count data checksum}, where count is the data's length plus 2 and the
 * checksum is big-endian, unlike all other numbers of the protocol.
 */
public final class P2osPacket {
    static final int HEADER_1 = 0xFA;
    static final int HEADER_2 = 0xFB;

    /** The largest count accepted; packets with a greater one are dropped. */
    static final int MAX_COUNT = 200;

    /** The smallest valid count: one byte of data and the checksum. */
    static final int MIN_COUNT = 3;

    private static final int CHECKSUM_LENGTH = 2;

    private P2osPacket() {}

    /** Returns an empty writer for a packet's data; numbers are little-endian. */
    static OctetWriter data() {
        return new OctetWriter(ByteOrder.LITTLE_ENDIAN);
    }

    /**
     * Frames the data.
     *
     * @throws IllegalArgumentException unless it has 1 to 198 bytes
     */
    public static byte[] of(byte[] data) {
        int count = data.length + CHECKSUM_LENGTH;
        if (count < MIN_COUNT || count > MAX_COUNT) {
            throw new IllegalArgumentException(
                    "a packet holds 1 to " + (MAX_COUNT - CHECKSUM_LENGTH) + " bytes of data, not " + data.length);
        }
        int checksum = checksum(data, 0, data.length);
        return data().octet(HEADER_1)
                .octet(HEADER_2)
                .octet(count)
                .bytes(data)
                .octet(checksum >> 8)
                .octet(checksum)
                .toArray();
    }

    /** Returns the sum of the big-endian pairs modulo 65536; an odd last byte is XORed into the low byte. */
    static int checksum(byte[] bytes, int from, int length) {
        int sum = 0;
        int end = from + length;
        int i = from;
        for (; i + 1 < end; i += 2) {
            sum = sum + ((bytes[i] & 0xFF) << 8) + (bytes[i + 1] & 0xFF) & 0xFFFF;
        }
        return i < end ? sum ^ (bytes[i] & 0xFF) : sum;
    }
}
