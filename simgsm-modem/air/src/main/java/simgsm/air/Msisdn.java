package simgsm.air;

/**
 * A telephone number as dialled or shown: 1 to 15 digits (ITU-T E.164), without a plus sign.
 *
 * @param digits decimal digits only
 */
public record Msisdn(String digits) {
    public static final int MAX_DIGITS = 15;

    public Msisdn {
        if (digits.isEmpty() || digits.length() > MAX_DIGITS || !isDigits(digits)) {
            throw new IllegalArgumentException("\"" + digits + "\" is not a telephone number of 1 to 15 digits");
        }
    }

    /** By hand, because numbers are made by the ten thousand a second and a pattern takes its time. */
    private static boolean isDigits(String text) {
        for (int i = 0; i < text.length(); i++) {
            if (text.charAt(i) < '0' || text.charAt(i) > '9') {
                return false;
            }
        }
        return true;
    }

    /** Reads a number as people write it: a leading plus sign is dropped. IllegalArgumentException says what is wrong. */
    public static Msisdn parse(String text) {
        return new Msisdn(text.startsWith("+") ? text.substring(1) : text);
    }

    @Override
    public String toString() {
        return digits;
    }
}
