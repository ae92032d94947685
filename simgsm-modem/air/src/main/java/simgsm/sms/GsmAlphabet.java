package simgsm.sms;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/** The GSM 7-bit default alphabet with its extension table (TS 23.038, 6.2.1). */
public final class GsmAlphabet {
    /** Precedes a code of the extension table. */
    static final int ESCAPE = 0x1b;

    static final int CARRIAGE_RETURN = 0x0d;

    private static final char NO_CHARACTER = '\uffff';

    /** Characters of the codes 0x00 to 0x7f; the escape has none. */
    private static final String TABLE = "@£$¥èéùìòÇ\nØø\rÅå"
            + "Δ_ΦΓΛΩΠΨΣΘΞ" + NO_CHARACTER + "ÆæßÉ"
            + " !\"#¤%&'()*+,-./"
            + "0123456789:;<=>?"
            + "¡ABCDEFGHIJKLMNO"
            + "PQRSTUVWXYZÄÖÑÜ§"
            + "¿abcdefghijklmno"
            + "pqrstuvwxyzäöñüà";

    private static final Map<Integer, Character> EXTENSION = Map.of(
            0x0a, '\f', 0x14, '^', 0x28, '{', 0x29, '}', 0x2f, '\\', 0x3c, '[', 0x3d, '~', 0x3e, ']', 0x40, '|', 0x65,
            '€');

    /** Code by character; codes of the extension table have the escape in the higher octet. */
    private static final Map<Character, Integer> CODES = new HashMap<>();

    static {
        for (int code = 0; code < TABLE.length(); code++) {
            if (code != ESCAPE) {
                CODES.put(TABLE.charAt(code), code);
            }
        }
        EXTENSION.forEach((code, character) -> CODES.put(character, ESCAPE << 8 | code));
    }

    private GsmAlphabet() {}

    /** True if every character of the text has a code. */
    public static boolean encodes(String text) {
        return text.chars().allMatch(character -> CODES.containsKey((char) character));
    }

    /** Septets of a character: 1, or 2 with the escape. */
    static int septetCount(char character) {
        return code(character) > 0x7f ? 2 : 1;
    }

    /** Codes 0 to 127, one an octet; IllegalArgumentException for a character that has none. */
    public static byte[] encode(String text) {
        byte[] codes = new byte[2 * text.length()];
        int count = 0;
        for (int i = 0; i < text.length(); i++) {
            int code = code(text.charAt(i));
            if (code > 0x7f) {
                codes[count++] = ESCAPE;
            }
            codes[count++] = (byte) (code & 0x7f);
        }
        return Arrays.copyOf(codes, count);
    }

    /**
     * The text of these codes. An escape before a code without extension is skipped, a double escape is a space, an
     * escape at the end is dropped (TS 23.038, 6.2.1.1).
     */
    public static String decode(byte[] codes) {
        StringBuilder text = new StringBuilder(codes.length);
        for (int i = 0; i < codes.length; i++) {
            int code = codes[i] & 0x7f;
            if (code != ESCAPE) {
                text.append(TABLE.charAt(code));
            } else if (++i < codes.length) {
                text.append(extended(codes[i] & 0x7f));
            }
        }
        return text.toString();
    }

    private static char extended(int code) {
        return code == ESCAPE ? ' ' : EXTENSION.getOrDefault(code, TABLE.charAt(code));
    }

    private static int code(char character) {
        Integer code = CODES.get(character);
        if (code == null) {
            throw new IllegalArgumentException("\"" + character + "\" is not in the GSM alphabet");
        }
        return code;
    }
}
