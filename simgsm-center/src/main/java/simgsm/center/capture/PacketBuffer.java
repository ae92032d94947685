package simgsm.center.capture;

import java.nio.ByteBuffer;

/** Packets as records of the file; grows up to a limit. */
final class PacketBuffer {
    /** Seconds, microseconds, octets here, octets on the wire: 4 octets each. */
    static final int RECORD_HEADER_LENGTH = 16;

    private static final int INITIAL_CAPACITY = 64 * 1024;

    private final int mostOctets;
    private ByteBuffer records = ByteBuffer.allocate(INITIAL_CAPACITY);

    PacketBuffer(int mostOctets) {
        this.mostOctets = mostOctets;
    }

    /** @return false if the buffer is full */
    boolean add(int seconds, int micros, byte[] packet) {
        int length = RECORD_HEADER_LENGTH + packet.length;
        if (records.remaining() < length && !grow(records.position() + length)) {
            return false;
        }
        records.putInt(seconds).putInt(micros).putInt(packet.length).putInt(packet.length);
        records.put(packet);
        return true;
    }

    private boolean grow(int needed) {
        if (needed > mostOctets) {
            return false;
        }
        int capacity = Math.min(mostOctets, Math.max(needed, 2 * records.capacity()));
        records = ByteBuffer.allocate(capacity).put(records.flip());
        return true;
    }

    boolean isEmpty() {
        return records.position() == 0;
    }

    int length() {
        return records.position();
    }

    /** The records to write; {@link #clear} follows. */
    ByteBuffer contents() {
        return records.duplicate().flip();
    }

    /** Also releases the memory of a burst. */
    void clear() {
        if (records.capacity() > INITIAL_CAPACITY && records.position() < INITIAL_CAPACITY / 2) {
            records = ByteBuffer.allocate(INITIAL_CAPACITY);
        } else {
            records.clear();
        }
    }
}
