package simrobot.replay;

import java.nio.charset.StandardCharsets;

/** Reads what {@link RecordingWriter} has written. Content that ends too early throws {@link DamagedException}. */
final class RecordingReader {
    private final byte[] octets;
    private int at;

    RecordingReader(byte[] octets) {
        this.octets = octets;
    }

    boolean hasMore() {
        return at < octets.length;
    }

    int octet() {
        if (at == octets.length) {
            throw new DamagedException("a record ends too early");
        }
        return octets[at++] & 0xFF;
    }

    /** The next octet, which stays. */
    int peek() {
        int octet = octet();
        at--;
        return octet;
    }

    long number() {
        long value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            int octet = octet();
            value |= (long) (octet & 0x7F) << shift;
            if (octet < 0x80) {
                return value;
            }
        }
        throw new DamagedException("a number never ends");
    }

    /** A number of things that follow, each of an octet or more. */
    int count() {
        long count = number();
        if (count < 0 || count > octets.length - at) {
            throw new DamagedException("a record counts " + count + " where fewer follow");
        }
        return (int) count;
    }

    long signed() {
        long value = number();
        return (value >>> 1) ^ -(value & 1);
    }

    long fixed(int count) {
        long value = 0;
        for (int i = 0; i < count; i++) {
            value = value << 8 | octet();
        }
        return value;
    }

    double exact() {
        return Double.longBitsToDouble(fixed(8));
    }

    String text() {
        int length = count();
        String text = new String(octets, at, length, StandardCharsets.UTF_8);
        at += length;
        return text;
    }
}
