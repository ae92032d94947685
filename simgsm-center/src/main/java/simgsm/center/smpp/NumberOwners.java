package simgsm.center.smpp;

import java.util.Comparator;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.air.Msisdn;
import simgsm.sms.SmsAddress;

/**
 * The numbers and names that applications list as {@code id.numbers}, each served and used as a sender by its
 * application only.
 */
final class NumberOwners {
    private static final String NUMBER = "\\+?([0-9]{1," + Msisdn.MAX_DIGITS + "})";
    private static final Pattern SPAN = Pattern.compile(NUMBER + "(?:-" + NUMBER + ")?");
    private static final Comparator<String> ORDER =
            Comparator.comparingInt(String::length).thenComparing(Comparator.naturalOrder());

    /** Numbers of one length, or a single name. */
    private record Span(String first, String last, String systemId) {}

    /** Spans by their first numbers; no two overlap. */
    private final NavigableMap<String, Span> spans = new TreeMap<>(ORDER);

    private final Set<String> systemIds = new HashSet<>();

    /**
     * Adds an application's list.
     *
     * @param list as {@code 7000-7099,6245,Alarm}
     * @throws IllegalArgumentException naming an invalid or already listed element
     */
    void add(String systemId, String list) {
        systemIds.add(systemId);
        for (String item : list.split(",")) {
            Matcher span = SPAN.matcher(item.strip());
            boolean isNumber = span.matches();
            String first = isNumber
                    ? span.group(1)
                    : key(SmsAddress.ofLetters(item.strip()).value());
            String last = isNumber && span.group(2) != null ? span.group(2) : first;
            if (first.isEmpty() || first.length() != last.length() || first.compareTo(last) > 0) {
                throw new IllegalArgumentException(
                        "expected numbers, ranges of numbers of one length and names, found \"" + item + "\"");
            }
            Map.Entry<String, Span> before = spans.floorEntry(last);
            if (before != null && ORDER.compare(before.getValue().last, first) >= 0) {
                throw new IllegalArgumentException(item + " is listed by " + before.getValue().systemId);
            }
            spans.put(first, new Span(first, last, systemId));
        }
    }

    boolean isOwner(String systemId) {
        return systemIds.contains(systemId);
    }

    /**
     * True if an application may serve or send as a number or name.
     *
     * @param isSubscribers true for a subscriber's number
     */
    boolean permits(String systemId, String value, boolean isSubscribers) {
        String key = key(value);
        Map.Entry<String, Span> at = spans.floorEntry(key);
        return at != null && ORDER.compare(key, at.getValue().last) <= 0
                ? at.getValue().systemId.equals(systemId)
                : !isOwner(systemId) && !isSubscribers;
    }

    /**
     * True if an application may serve numbers with this prefix: it lists all of one length, or no application lists
     * any.
     */
    boolean permitsPrefix(String systemId, String prefix) {
        boolean isOwner = isOwner(systemId);
        return isOwner
                == spans.values().stream()
                        .filter(span ->
                                span.first.length() >= prefix.length() && isOwner == span.systemId.equals(systemId))
                        .anyMatch(span -> {
                            int more = span.first.length() - prefix.length();
                            String low = prefix + "0".repeat(more);
                            String high = prefix + "9".repeat(more);
                            return isOwner
                                    ? span.first.compareTo(low) <= 0 && span.last.compareTo(high) >= 0
                                    : span.first.compareTo(high) <= 0 && span.last.compareTo(low) >= 0;
                        });
    }

    private static String key(String value) {
        return (value.startsWith("+") ? value.substring(1) : value).toLowerCase(Locale.ROOT);
    }
}
