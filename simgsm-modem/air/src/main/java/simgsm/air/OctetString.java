package simgsm.air;

import java.util.Arrays;
import java.util.HexFormat;

/** An immutable run of octets with value equality; {@code toString} is lower-case hexadecimal. */
public final class OctetString {
    private final byte[] octets;

    private OctetString(byte[] octets) {
        this.octets = octets;
    }

    /** A copy of the given octets. */
    public static OctetString of(byte[] octets) {
        return new OctetString(octets.clone());
    }

    /** Takes the array itself, which nobody may change any more. */
    static OctetString adopting(byte[] octets) {
        return new OctetString(octets);
    }

    void copyTo(byte[] target, int position) {
        System.arraycopy(octets, 0, target, position, octets.length);
    }

    /** A reader that starts at the first octet. */
    public OctetReader reader() {
        return new OctetReader(octets);
    }

    /** From hexadecimal digits, without blanks; IllegalArgumentException for anything else. */
    public static OctetString ofHex(String hex) {
        return new OctetString(HexFormat.of().parseHex(hex));
    }

    public int length() {
        return octets.length;
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
