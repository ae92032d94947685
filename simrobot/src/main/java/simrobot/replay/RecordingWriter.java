package simrobot.replay;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Octets that grow as they are written; small numbers take few. */
final class RecordingWriter {
    private byte[] octets = new byte[1024];
    private int size;

    int size() {
        return size;
    }

    void clear() {
        size = 0;
    }

    byte[] toArray() {
        return Arrays.copyOf(octets, size);
    }

    RecordingWriter octet(int value) {
        if (size == octets.length) {
            octets = Arrays.copyOf(octets, 2 * size);
        }
        octets[size++] = (byte) value;
        return this;
    }

    /** Seven bits an octet, lowest first; the eighth says that more follow. */
    RecordingWriter number(long value) {
        long rest = value;
        while ((rest & ~0x7FL) != 0) {
            octet((int) (rest & 0x7F) | 0x80);
            rest >>>= 7;
        }
        return octet((int) rest);
    }

    /** Small when it is near 0, of either sign. */
    RecordingWriter signed(long value) {
        return number((value << 1) ^ (value >> 63));
    }

    RecordingWriter fixed(long value, int count) {
        for (int shift = 8 * (count - 1); shift >= 0; shift -= 8) {
            octet((int) (value >>> shift));
        }
        return this;
    }

    /** All its bits. */
    RecordingWriter exact(double value) {
        return fixed(Double.doubleToRawLongBits(value), 8);
    }

    RecordingWriter text(String text) {
        byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
        return number(utf8.length).octets(utf8);
    }

    RecordingWriter octets(byte[] more) {
        if (size + more.length > octets.length) {
            octets = Arrays.copyOf(octets, Math.max(2 * octets.length, size + more.length));
        }
        System.arraycopy(more, 0, octets, size, more.length);
        size += more.length;
        return this;
    }
}
