package simgsm.center.smpp;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import simgsm.air.Msisdn;

/**
 * The numbers that an application serves (5.2.7): one number, as {@code 5550300}; a prefix, as {@code 5553*} or {@code
 * ^5553}; or a POSIX regular expression for the whole number, as {@code 555[0-9]{4}}.
 */
final class AddressRange {
    private static final Pattern PREFIX = Pattern.compile("\\^?\\+?([0-9]+)(\\.?\\*)?");
    private static final Pattern HARMLESS = Pattern.compile("[0-9+^$.*?()|\\[\\]{},-]+");

    private final String text;
    private final Optional<Msisdn> exact;
    private final String prefix;
    private final Pattern pattern;

    private AddressRange(String text, Optional<Msisdn> exact, String prefix, Pattern pattern) {
        this.text = text;
        this.exact = exact;
        this.prefix = prefix;
        this.pattern = pattern;
    }

    /** @throws IllegalArgumentException if the text is none of the three forms */
    static AddressRange parse(String text) {
        String plain = text.startsWith("+") ? text.substring(1) : text;
        if (plain.matches("[0-9]{1," + Msisdn.MAX_DIGITS + "}")) {
            return new AddressRange(plain, Optional.of(new Msisdn(plain)), plain, null);
        }
        Matcher prefix = PREFIX.matcher(text);
        if (prefix.matches() && (text.startsWith("^") || prefix.group(2) != null)) {
            return new AddressRange(text, Optional.empty(), prefix.group(1), null);
        }
        if (!HARMLESS.matcher(text).matches()) {
            throw new IllegalArgumentException("\"" + text + "\" is no number, beginning of numbers or pattern");
        }
        try {
            boolean isOpen = text.startsWith("^") && !text.endsWith("$");
            Pattern pattern = Pattern.compile(isOpen ? text + ".*" : text);
            return new AddressRange(text, Optional.empty(), leadingDigits(text), pattern);
        } catch (PatternSyntaxException e) {
            throw new IllegalArgumentException("\"" + text + "\" is no pattern: " + e.getDescription());
        }
    }

    /** The literal digits at the start of a pattern. */
    private static String leadingDigits(String pattern) {
        int from = pattern.startsWith("^") ? 1 : 0;
        int to = from;
        while (to < pattern.length() && Character.isDigit(pattern.charAt(to))) {
            to++;
        }
        boolean lastIsOptional = to < pattern.length() && "*?{".indexOf(pattern.charAt(to)) >= 0;
        return pattern.indexOf('|') >= 0 ? "" : pattern.substring(from, Math.max(from, to - (lastIsOptional ? 1 : 0)));
    }

    /** The only number of the range; empty for a prefix or pattern. */
    Optional<Msisdn> exact() {
        return exact;
    }

    boolean contains(Msisdn number) {
        return exact.isPresent()
                ? exact.get().equals(number)
                : pattern == null
                        ? number.digits().startsWith(prefix)
                        : pattern.matcher(number.digits()).matches();
    }

    /** Length of the common prefix; the range with the longest one gets the message. */
    int closeness() {
        return exact.isPresent() ? Integer.MAX_VALUE : prefix.length();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof AddressRange that && text.equals(that.text);
    }

    @Override
    public int hashCode() {
        return text.hashCode();
    }

    @Override
    public String toString() {
        return text;
    }
}
