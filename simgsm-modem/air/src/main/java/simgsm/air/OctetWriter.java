package simgsm.air;

import java.util.Arrays;

/** Puts octets one behind the other; grows as needed. */
public final class OctetWriter {
    /** Long enough for every message of a call and for most short messages without growing. */
    private static final int INITIAL_CAPACITY = 64;

    private byte[] octets = new byte[INITIAL_CAPACITY];
    private int length;

    /** With nothing written yet. */
    public OctetWriter() {}

    public OctetWriter octet(int value) {
        reserve(1);
        octets[length++] = (byte) value;
        return this;
    }

    /** The higher octet first. */
    public OctetWriter twoOctets(int value) {
        return octet(value >> 8).octet(value);
    }

    /** The highest octet first. */
    public OctetWriter fourOctets(long value) {
        return twoOctets((int) (value >> 16)).twoOctets((int) value);
    }

    public OctetWriter bytes(byte[] values) {
        reserve(values.length);
        System.arraycopy(values, 0, octets, length, values.length);
        length += values.length;
        return this;
    }

    public OctetWriter string(OctetString values) {
        reserve(values.length());
        values.copyTo(octets, length);
        length += values.length();
        return this;
    }

    /** Keeps an octet free for a length that is known later; give the answer to {@link #closeLength}. */
    public int openLength() {
        octet(0);
        return length;
    }

    /** Writes into the octet kept by {@link #openLength} how many octets followed it. */
    public OctetWriter closeLength(int start) {
        int count = length - start;
        if (count > 0xff) {
            throw new IllegalArgumentException("an element of " + count + " octets does not fit a length octet");
        }
        octets[start - 1] = (byte) count;
        return this;
    }

    public int length() {
        return length;
    }

    public byte[] toArray() {
        return Arrays.copyOf(octets, length);
    }

    private void reserve(int count) {
        if (length + count > octets.length) {
            octets = Arrays.copyOf(octets, Math.max(octets.length * 2, length + count));
        }
    }
}
