package simgsm.air;

import java.util.Optional;

/**
 * International mobile subscriber identity: country code, network code, subscriber (TS 23.003, 2.2).
 *
 * @param digits 6 to 15 decimal digits
 */
public record Imsi(String digits) implements MobileIdentity {
    /** Mobile country and network code of the test network. */
    public static final String TEST_NETWORK = "00101";

    private static final int OPEN_NETWORK_DIGITS = 10;

    public Imsi {
        if (!digits.matches("[0-9]{6,15}")) {
            throw new IllegalArgumentException("IMSI \"" + digits + "\" is not 6 to 15 digits");
        }
    }

    /**
     * The identity of a number in an open network: 00101 and the number padded left to ten digits.
     *
     * @throws IllegalArgumentException for a number of more than ten digits or with a leading zero, because its IMSI
     *     would be another number's
     */
    public static Imsi ofOpenNumber(Msisdn number) {
        String digits = number.digits();
        if (digits.length() > OPEN_NETWORK_DIGITS || digits.startsWith("0")) {
            throw new IllegalArgumentException(
                    "a subscriber's number has 1 to 10 digits and no leading zero, not \"" + digits + "\"");
        }
        return new Imsi(TEST_NETWORK + "0".repeat(OPEN_NETWORK_DIGITS - digits.length()) + digits);
    }

    /** The number of an identity made by {@link #ofOpenNumber}; empty for any other. */
    public Optional<Msisdn> openNumber() {
        if (digits.length() != TEST_NETWORK.length() + OPEN_NETWORK_DIGITS || !digits.startsWith(TEST_NETWORK)) {
            return Optional.empty();
        }
        String number = digits.substring(TEST_NETWORK.length()).replaceFirst("^0+", "");
        return number.isEmpty() ? Optional.empty() : Optional.of(new Msisdn(number));
    }

    @Override
    public Type type() {
        return Type.IMSI;
    }

    @Override
    public String toString() {
        return digits;
    }
}
