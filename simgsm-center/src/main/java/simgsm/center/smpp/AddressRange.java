package simgsm.center.smpp;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.air.Msisdn;

/**
 * The numbers that an application serves (5.2.7).
 *
 * @param digits the number, or a prefix
 * @param isPrefix true for a prefix
 * @param owner the application whose listed numbers are meant; empty for any numbers
 */
record AddressRange(String digits, boolean isPrefix, String owner) {
    /** {@code 5550300}, {@code ^5550300$}; {@code 555*}, {@code 555.*}, {@code ^555.*$}, {@code ^555}. */
    private static final Pattern FORM =
            Pattern.compile("(\\^)?\\+?([0-9]{1," + Msisdn.MAX_DIGITS + "})(\\.?\\*)?(\\$)?");

    /** @throws IllegalArgumentException if the text is neither a number nor a prefix */
    static AddressRange parse(String text, String owner) {
        Matcher form = FORM.matcher(text);
        if (!form.matches()) {
            throw new IllegalArgumentException("\"" + text + "\" is neither a number nor a beginning such as 555*");
        }
        boolean isOpen = form.group(1) != null && form.group(4) == null;
        return new AddressRange(form.group(2), form.group(3) != null || isOpen, owner);
    }

    /** The only number of the range; empty for a prefix. */
    Optional<Msisdn> exact() {
        return isPrefix ? Optional.empty() : Optional.of(new Msisdn(digits));
    }

    boolean contains(Msisdn number) {
        return isPrefix ? number.digits().startsWith(digits) : number.digits().equals(digits);
    }

    /** Length of the common prefix; the longest range gets the message. */
    int closeness() {
        return digits.length();
    }

    @Override
    public String toString() {
        return isPrefix ? digits + "*" : digits;
    }
}
