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
