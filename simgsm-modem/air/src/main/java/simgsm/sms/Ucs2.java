package simgsm.sms;

/** UCS-2, the higher octet first. Unlike UTF-16 of the JDK, it keeps single surrogates. */
public final class Ucs2 {
    private Ucs2() {}

    /** Two octets a character. */
    public static byte[] encode(String text) {
        byte[] octets = new byte[2 * text.length()];
        for (int i = 0; i < text.length(); i++) {
            octets[2 * i] = (byte) (text.charAt(i) >> 8);
            octets[2 * i + 1] = (byte) text.charAt(i);
        }
        return octets;
    }

    /** The text of the octets from {@code start} on; a single octet at the end is dropped. */
    public static String decode(byte[] octets, int start) {
        StringBuilder text = new StringBuilder((octets.length - start) / 2);
        for (int i = start; i + 1 < octets.length; i += 2) {
            text.append((char) ((octets[i] & 0xff) << 8 | octets[i + 1] & 0xff));
        }
        return text.toString();
    }
}
