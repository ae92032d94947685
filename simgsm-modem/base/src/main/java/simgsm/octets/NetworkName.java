package simgsm.octets;

import java.nio.charset.StandardCharsets;

/**
 * The network's name for a phone's display (TS 24.008, 10.5.3.5a): septets if every character has the same code in the
 * GSM alphabet and in ASCII, else UCS-2.
 */
public final class NetworkName {
    private static final String SAME_IN_GSM_AND_ASCII = "A-Za-z0-9 !\"#%&'()*+,\\-./:;<=>?";
    private static final String OTHERS = "[^" + SAME_IN_GSM_AND_ASCII + "]";
    private static final int EXTENSION_BIT = 0x80;
    private static final int UCS2 = 0x10;
    private static final int CODING_MASK = 0x70;
    private static final String UNKNOWN = "?";
    private static final int MAX_LENGTH = 64;

    private NetworkName() {}

    /** Writes a name of at most 64 characters. */
    public static void write(OctetWriter out, String name) {
        if (name.matches("[" + SAME_IN_GSM_AND_ASCII + "]*")) {
            byte[] packed = Septets.pack(name.getBytes(StandardCharsets.US_ASCII), 0);
            int spareBits = packed.length * 8 - name.length() * 7;
            out.octet(EXTENSION_BIT | spareBits).bytes(packed);
        } else {
            out.octet(EXTENSION_BIT | UCS2).bytes(name.getBytes(StandardCharsets.UTF_16BE));
        }
    }

    /** The first 64 characters of a name. @param coding the first octet of the value; @param octets the others */
    public static String read(int coding, byte[] octets) {
        String name = (coding & CODING_MASK) == UCS2 ? ucs2(octets) : septets(octets, coding & 0x07);
        return name.substring(0, Math.min(name.length(), MAX_LENGTH));
    }

    private static String ucs2(byte[] octets) {
        String name = new String(octets, 0, octets.length & ~1, StandardCharsets.UTF_16BE);
        return name.replaceAll("\\p{Cntrl}", UNKNOWN);
    }

    private static String septets(byte[] octets, int spareBits) {
        byte[] codes = Septets.unpack(octets, Math.max(0, (octets.length * 8 - spareBits) / 7), 0);
        return new String(codes, StandardCharsets.US_ASCII).replaceAll(OTHERS, UNKNOWN);
    }
}
