package simrobot.p2os;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Finds packets in an arbitrary byte stream. Packets with a wrong checksum are dropped whole, invalid counts are
 * skipped with their header; both are counted.
 */
public final class P2osPacketReader {
    /** An incomplete packet is dropped after this time without bytes if the next bytes begin with a header. */
    private static final long STALE_NANOS = 100_000_000;

    private final byte[] body = new byte[P2osPacket.MAX_COUNT];
    private final Consumer<byte[]> packets;
    private Seen seen = Seen.NOTHING;
    private int count;
    private int filled;
    private long lastNanos;
    private long rejected;

    private enum Seen {
        NOTHING,
        FIRST_HEADER,
        HEADER,
        COUNT
    }

    /** @param packets receives the data of each valid packet, without its frame */
    public P2osPacketReader(Consumer<byte[]> packets) {
        this.packets = packets;
    }

    /** Returns the number of headers without a valid packet. */
    public long rejected() {
        return rejected;
    }

    /** @param nanos the time at which the bytes arrived */
    public void read(byte[] bytes, long nanos) {
        boolean opens = bytes.length >= 2
                && (bytes[0] & 0xFF) == P2osPacket.HEADER_1
                && (bytes[1] & 0xFF) == P2osPacket.HEADER_2;
        if (opens && seen != Seen.NOTHING && nanos - lastNanos > STALE_NANOS) {
            reject();
        }
        lastNanos = nanos;
        for (byte octet : bytes) {
            read(octet);
        }
    }

    private void read(byte octet) {
        int value = octet & 0xFF;
        switch (seen) {
            case NOTHING -> seen = value == P2osPacket.HEADER_1 ? Seen.FIRST_HEADER : Seen.NOTHING;
            case FIRST_HEADER -> {
                if (value == P2osPacket.HEADER_2) {
                    seen = Seen.HEADER;
                } else {
                    seen = value == P2osPacket.HEADER_1 ? Seen.FIRST_HEADER : Seen.NOTHING;
                }
            }
            case HEADER -> count(value);
            case COUNT -> fill(octet);
        }
    }

    private void count(int value) {
        if (value < P2osPacket.MIN_COUNT || value > P2osPacket.MAX_COUNT) {
            reject();
            // 0xFA is no valid count, but may begin the next header
            seen = value == P2osPacket.HEADER_1 ? Seen.FIRST_HEADER : Seen.NOTHING;
        } else {
            count = value;
            filled = 0;
            seen = Seen.COUNT;
        }
    }

    private void fill(byte octet) {
        body[filled++] = octet;
        if (filled < count) {
            return;
        }
        seen = Seen.NOTHING;
        int length = count - 2;
        int sum = (body[length] & 0xFF) << 8 | body[length + 1] & 0xFF;
        if (sum == P2osPacket.checksum(body, 0, length)) {
            packets.accept(Arrays.copyOf(body, length));
        } else {
            reject();
        }
    }

    private void reject() {
        rejected++;
        seen = Seen.NOTHING;
    }
}
