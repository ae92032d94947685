package simgsm.air;

import java.util.random.RandomGenerator;

/**
 * International mobile equipment identity: type allocation code (8), serial number (6), Luhn digit (TS 23.003, 6.2).
 * Messages have 0 instead of the Luhn digit (TS 22.016, 2).
 *
 * @param digits 15 decimal digits; the last is the Luhn digit, which replaces a 0
 */
public record Imei(String digits) implements MobileIdentity {
    /** Type allocation code of the suite's terminals, from the range reserved for tests. */
    private static final String TYPE_ALLOCATION_CODE = "00101750";

    private static final int SERIAL_DIGITS = 6;

    public Imei {
        if (!digits.matches("[0-9]{15}")) {
            throw new IllegalArgumentException("IMEI \"" + digits + "\" is not 15 digits");
        }
        char last = digits.charAt(14);
        char luhn = luhnDigit(digits.substring(0, 14));
        if (last != '0' && last != luhn) {
            throw new IllegalArgumentException("IMEI \"" + digits + "\" has a wrong check digit, expected " + luhn);
        }
        digits = digits.substring(0, 14) + luhn;
    }

    /** In the form of messages; the receiver ignores the 15th digit. */
    static String transmitted(String digits) {
        return digits.length() == 15 ? digits.substring(0, 14) + '0' : digits;
    }

    /** A new identity of the suite's type with a random serial number. */
    public static Imei random(RandomGenerator random) {
        return of(TYPE_ALLOCATION_CODE, random.nextInt(1_000_000));
    }

    /**
     * The identity of one equipment of a type.
     *
     * @param typeAllocationCode 8 digits
     * @param serialNumber 0 to 999999
     */
    public static Imei of(String typeAllocationCode, int serialNumber) {
        String serial = Integer.toString(serialNumber);
        String body = typeAllocationCode + "0".repeat(SERIAL_DIGITS - serial.length()) + serial;
        return new Imei(body + luhnDigit(body));
    }

    private static char luhnDigit(String body) {
        int sum = 0;
        for (int i = 0; i < body.length(); i++) {
            int digit = body.charAt(i) - '0';
            int weighted = i % 2 == 1 ? digit * 2 : digit;
            sum += weighted / 10 + weighted % 10;
        }
        return (char) ('0' + (10 - sum % 10) % 10);
    }

    @Override
    public Type type() {
        return Type.IMEI;
    }

    @Override
    public String toString() {
        return digits;
    }
}
