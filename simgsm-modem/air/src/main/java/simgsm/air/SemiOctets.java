package simgsm.air;

import simgsm.octets.OctetWriter;

/** Digits in pairs, the first in the lower half of its octet; a half octet of ones fills an odd end. */
public final class SemiOctets {
    private static final String SYMBOLS = "0123456789*#abc";
    private static final int FILLER = 0x0f;

    private SemiOctets() {}

    /** Writes the digits from {@code start}. IllegalArgumentException for a character other than 0-9 * # a-c. */
    public static void write(OctetWriter out, String digits, int start) {
        for (int i = start; i < digits.length(); i += 2) {
            int high = i + 1 < digits.length() ? code(digits.charAt(i + 1)) : FILLER;
            out.octet(high << 4 | code(digits.charAt(i)));
        }
    }

    /** All digits up to the filler or the end; any of 0-9 * # a-c. */
    public static String read(MessageReader in) throws ProtocolViolation {
        StringBuilder digits = new StringBuilder(2 * in.remaining());
        while (in.hasMore()) {
            int pair = in.octet("digits");
            append(digits, pair & 0x0f);
            if (pair >> 4 == FILLER && !in.hasMore()) {
                return digits.toString();
            }
            append(digits, pair >> 4);
        }
        return digits.toString();
    }

    /** Exactly {@code count} decimal digits, or a {@link ProtocolViolation}; an odd count must be filled. */
    public static String readDecimal(MessageReader in, int count) throws ProtocolViolation {
        String digits = readCounted(in, count);
        for (int i = 0; i < digits.length(); i++) {
            if (digits.charAt(i) > '9' || digits.charAt(i) < '0') {
                throw ProtocolViolation.invalid(
                        "a digit \"" + digits.charAt(i) + "\" where only decimal ones may stand");
            }
        }
        return digits;
    }

    /** Exactly {@code count} digits of 0-9 * # a-c, or a {@link ProtocolViolation}. */
    public static String readCounted(MessageReader in, int count) throws ProtocolViolation {
        StringBuilder digits = new StringBuilder(count);
        while (digits.length() < count) {
            int pair = in.octet("digits");
            append(digits, pair & 0x0f);
            if (digits.length() < count) {
                append(digits, pair >> 4);
            } else if (pair >> 4 != FILLER) {
                throw ProtocolViolation.invalid(
                        "an odd number of digits ends with " + (pair >> 4) + " instead of a filler");
            }
        }
        return digits.toString();
    }

    private static void append(StringBuilder digits, int nibble) throws ProtocolViolation {
        if (nibble == FILLER) {
            throw ProtocolViolation.invalid("a filler inside a number");
        }
        digits.append(SYMBOLS.charAt(nibble));
    }

    private static int code(char digit) {
        int code = SYMBOLS.indexOf(digit);
        if (code < 0) {
            throw new IllegalArgumentException("\"" + digit + "\" is no digit of a telephone number");
        }
        return code;
    }
}
