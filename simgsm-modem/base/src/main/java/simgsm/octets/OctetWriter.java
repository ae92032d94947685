package simgsm.octets;

import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Appends octets to a growing array. Numbers have their highest octet first unless the constructor got another order.
 */
public final class OctetWriter {
    /** Octets; enough for a speech frame with its headers and for almost every message. */
    private static final int INITIAL_CAPACITY = 256;

    private final boolean isLittleEndian;
    private byte[] octets = new byte[INITIAL_CAPACITY];
    private int length;

    /** An empty writer, highest octet first. */
    public OctetWriter() {
        this(ByteOrder.BIG_ENDIAN);
    }

    /** An empty writer with this order of the octets of a number. */
    public OctetWriter(ByteOrder order) {
        isLittleEndian = order == ByteOrder.LITTLE_ENDIAN;
    }

    /** Appends the low 8 bits. */
    public OctetWriter octet(int value) {
        reserve(1);
        octets[length++] = (byte) value;
        return this;
    }

    /** Appends the low 16 bits of each value. */
    public OctetWriter twoOctets(int... values) {
        for (int value : values) {
            number(value, 2);
        }
        return this;
    }

    /** Appends the low 32 bits. */
    public OctetWriter fourOctets(long value) {
        return number(value, 4);
    }

    /** Appends all 64 bits. */
    public OctetWriter eightOctets(long value) {
        return number(value, 8);
    }

    private OctetWriter number(long value, int count) {
        for (int i = 0; i < count; i++) {
            octet((int) (value >>> 8 * (isLittleEndian ? i : count - 1 - i)));
        }
        return this;
    }

    /** Appends a number in IEEE 754 binary64, 8 octets. */
    public OctetWriter real(double value) {
        return eightOctets(Double.doubleToRawLongBits(value));
    }

    /** Appends an unsigned number in LEB128, 1 to 10 octets; see {@link OctetReader#compact}. */
    public OctetWriter compact(long value) {
        long rest = value;
        for (; (rest & ~0x7fL) != 0; rest >>>= 7) {
            octet((int) rest | 0x80);
        }
        return octet((int) rest);
    }

    /** Appends a text in UTF-8, led by its number of octets in LEB128. */
    public OctetWriter text(String text) {
        byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
        return compact(utf8.length).bytes(utf8);
    }

    /** Appends a text in ISO 8859-1 and an octet 0. */
    public OctetWriter zeroEnded(String text) {
        return bytes(text.getBytes(StandardCharsets.ISO_8859_1)).octet(0);
    }

    /** Appends octets. */
    public OctetWriter bytes(byte[] values) {
        reserve(values.length);
        System.arraycopy(values, 0, octets, length, values.length);
        length += values.length;
        return this;
    }

    /** Appends octets. */
    public OctetWriter string(OctetString values) {
        reserve(values.length());
        values.copyTo(octets, length);
        length += values.length();
        return this;
    }

    /** Appends an octet for a length that is known later; the result is for {@link #closeLength}. */
    public int openLength() {
        octet(0);
        return length;
    }

    /**
     * Sets the octet of {@link #openLength} to the number of octets that followed it.
     *
     * @throws IllegalArgumentException if there are over 255
     */
    public OctetWriter closeLength(int start) {
        int count = length - start;
        if (count > 0xff) {
            throw new IllegalArgumentException("an element of " + count + " octets does not fit a length octet");
        }
        octets[start - 1] = (byte) count;
        return this;
    }

    /** Moves the low half of the last octet into the high half of the one before. */
    public void joinHalves() {
        length--;
        octets[length - 1] |= (byte) (octets[length] << 4);
    }

    /** The number of octets written. */
    public int length() {
        return length;
    }

    /** Empties the writer. */
    public void clear() {
        length = 0;
    }

    /** A copy of the octets written. */
    public byte[] toArray() {
        return Arrays.copyOf(octets, length);
    }

    /** The octets written so far. */
    public OctetString toOctetString() {
        return OctetString.adopting(toArray());
    }

    private void reserve(int count) {
        if (length + count > octets.length) {
            octets = Arrays.copyOf(octets, Math.max(octets.length * 2, length + count));
        }
    }
}
