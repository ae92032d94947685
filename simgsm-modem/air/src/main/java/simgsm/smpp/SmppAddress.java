package simgsm.smpp;

import java.util.Optional;
import java.util.Set;
import simgsm.air.Msisdn;
import simgsm.sms.SmsAddress;

/**
 * A source or destination (5.2.5 to 5.2.9).
 *
 * @param ton type of number
 * @param npi numbering plan
 * @param value as sent, at most 20 characters
 */
public record SmppAddress(int ton, int npi, String value) {
    public static final SmppAddress NONE = new SmppAddress(0, 0, "");

    private static final int LETTERS = 5;
    private static final int NETWORK_DIGITS = 10;
    /** addr_ton (5.2.5): unknown ... abbreviated. */
    private static final int MAX_TON = 6;

    /** addr_npi (5.2.6); 18, a WAP client's id, cannot be a mobile's address. */
    private static final Set<Integer> PLANS = Set.of(0, 1, 3, 4, 6, 8, 9, 10, 14);

    public static SmppAddress of(SmsAddress address) {
        return new SmppAddress(address.type(), address.plan(), address.value());
    }

    /** The telephone number; empty if the address is not one. */
    public Optional<Msisdn> number() {
        String digits = value.startsWith("+") ? value.substring(1) : value;
        if (ton == LETTERS || digits.isEmpty() || digits.length() > Msisdn.MAX_DIGITS || !Msisdn.isDigits(digits)) {
            return Optional.empty();
        }
        return Optional.of(new Msisdn(digits));
    }

    /** {@link SmppStatus#OK}, or the given status for an invalid type of number or numbering plan. */
    public int check(int typeStatus, int planStatus) {
        return ton > MAX_TON ? typeStatus : PLANS.contains(npi) ? SmppStatus.OK : planStatus;
    }

    /**
     * The address for a mobile: a number, or up to 11 letters for any type of number; empty if it is neither. Numbers
     * of the network have at most 10 digits and no country code, but most applications call every number international:
     * these are of unknown type for a mobile.
     */
    public Optional<SmsAddress> forMobiles() {
        if (value.isEmpty()) {
            return Optional.empty();
        }
        Optional<String> digits = number().map(Msisdn::digits);
        boolean isOfNetwork = ton == SmsAddress.INTERNATIONAL
                && digits.filter(it -> it.length() <= NETWORK_DIGITS).isPresent();
        try {
            return Optional.of(
                    digits.isPresent()
                            ? new SmsAddress(isOfNetwork ? SmsAddress.UNKNOWN : ton, npi, digits.get())
                            : SmsAddress.ofLetters(value));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }
}
