package simgsm.octets;

/**
 * Seven-bit codes packed into octets (TS 23.038, 6.1.2): code i begins at bit 7 i, counted from the lowest bit of the
 * first octet.
 *
 * <pre>
 *   octet 0: 1aaaaaaa   a = code 0, the lowest bit of code 1 on top
 *   octet 1: 22bbbbbb   ...
 * </pre>
 */
public final class Septets {
    private Septets() {}

    /** The number of octets for these fill bits and septets. */
    public static int octetCount(int septets, int fillBits) {
        return (septets * 7 + fillBits + 7) / 8;
    }

    /** @param fillBits zero bits before the first code, 0 to 6, used after a user data header */
    public static byte[] pack(byte[] codes, int fillBits) {
        byte[] octets = new byte[octetCount(codes.length, fillBits)];
        int bit = fillBits;
        for (byte code : codes) {
            int shifted = (code & 0x7f) << (bit & 7);
            octets[bit >> 3] |= (byte) shifted;
            if (shifted > 0xff) {
                octets[(bit >> 3) + 1] |= (byte) (shifted >> 8);
            }
            bit += 7;
        }
        return octets;
    }

    /** The first {@code count} codes; {@code octets} must hold as many. */
    public static byte[] unpack(byte[] octets, int count, int fillBits) {
        byte[] codes = new byte[count];
        int bit = fillBits;
        for (int i = 0; i < count; i++) {
            int index = bit >> 3;
            int pair = octets[index] & 0xff | (index + 1 < octets.length ? (octets[index + 1] & 0xff) << 8 : 0);
            codes[i] = (byte) (pair >> (bit & 7) & 0x7f);
            bit += 7;
        }
        return codes;
    }
}
