package simgsm.octets;

import java.util.Arrays;
import java.util.HexFormat;

/** An immutable string of octets, compared by value; {@code toString} is lower-case hexadecimal. */
public final class OctetString {
    private final byte[] octets;

    private OctetString(byte[] octets) {
        this.octets = octets;
    }

    /** A copy of the given octets. */
    public static OctetString of(byte[] octets) {
        return new OctetString(octets.clone());
    }

    /** Takes the array itself, which must not change afterwards. */
    static OctetString adopting(byte[] octets) {
        return new OctetString(octets);
    }

    void copyTo(byte[] target, int position) {
        System.arraycopy(octets, 0, target, position, octets.length);
    }

    /** The octet at the index, 0 to 255. */
    public int octet(int index) {
        return octets[index] & 0xff;
    }

    /** Parses hexadecimal digits without blanks; IllegalArgumentException for anything else. */
    public static OctetString ofHex(String hex) {
        return new OctetString(HexFormat.of().parseHex(hex));
    }

    /** The number of octets. */
    public int length() {
        return octets.length;
    }

    /**
     * Checks the number of octets.
     *
     * @return this
     * @throws IllegalArgumentException as "what has 5 octets, 16 were expected" if it is another
     */
    public OctetString requireLength(String what, int expected) {
        return requireLength(what, expected, expected);
    }

    /** Checks that there are {@code least} to {@code most} octets; see {@link #requireLength(String, int)}. */
    public OctetString requireLength(String what, int least, int most) {
        if (octets.length < least || octets.length > most) {
            throw new IllegalArgumentException(what + " has " + octets.length + " octets, "
                    + (least == most ? "" : least + " to ") + most + " were expected");
        }
        return this;
    }

    /** A copy of the octets. */
    public byte[] toArray() {
        return octets.clone();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof OctetString that && Arrays.equals(octets, that.octets);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(octets);
    }

    @Override
    public String toString() {
        return HexFormat.of().formatHex(octets);
    }
}
