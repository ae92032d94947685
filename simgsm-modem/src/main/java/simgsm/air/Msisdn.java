package simgsm.air;

/**
 * A telephone number as dialled or shown: 1 to 15 digits (ITU-T E.164), without a plus sign.
 *
 * @param digits decimal digits only
 */
public record Msisdn(String digits) {
    public static final int MAX_DIGITS = 15;

    public Msisdn {
        if (!digits.matches("[0-9]{1," + MAX_DIGITS + "}")) {
            throw new IllegalArgumentException("\"" + digits + "\" is not a telephone number of 1 to 15 digits");
        }
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
