package simgsm.gateway.mail;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The addresses at the beginning of a short message, and what follows (TS 23.040, 3.8): {@code to text}, {@code
 * to(subject)text}, {@code to##subject#text}, {@code to#name##subject#text}, {@code to#flag#text}; several addresses
 * parted by commas; {@code *} for {@code @} and {@code $} for {@code _}.
 */
record MailAddresses(List<String> to, String name, String subject, String text) {
    private static final String WORD = "[A-Za-z0-9!%&'+/=?^_`{|}~$-]+(?:\\.[A-Za-z0-9!%&'+/=?^_`{|}~$-]+)*";
    private static final String DOMAIN = "[A-Za-z0-9](?:[A-Za-z0-9-]*[A-Za-z0-9])?";
    private static final Pattern ADDRESS = Pattern.compile(
            WORD + "@" + DOMAIN + "(?:\\." + DOMAIN + ")*|" + WORD + "\\*" + DOMAIN + "(?:\\." + DOMAIN + ")+");
    private static final Pattern START = Pattern.compile("[^ (#\r\n]*");
    private static final Pattern IN_BRACKETS = Pattern.compile("()\\(([^)]*)\\)(.*)", Pattern.DOTALL);
    private static final Pattern WITH_HASHES = Pattern.compile("(?:#([^#]*))?##([^#]*)#(.*)", Pattern.DOTALL);
    private static final Pattern WITH_FLAG = Pattern.compile("()()#[^#]*#(.*)", Pattern.DOTALL);
    private static final Pattern PLAIN = Pattern.compile("()()(?:[ \r\n](.*))?", Pattern.DOTALL);
    /** Octets of an address in RFC 5321, 4.5.3.1. */
    private static final int MOST_ADDRESS = 254;
    /** Recipients of a mail that each server takes (RFC 5321, 4.5.3.1.8). */
    private static final int MOST_ADDRESSES = 100;

    /** Empty if the text does not begin with an address. */
    static Optional<MailAddresses> parse(String message) {
        String text = message.stripLeading();
        Matcher start = START.matcher(text);
        if (!start.lookingAt()) {
            return Optional.empty();
        }
        List<String> words = List.of(start.group().split(",", MOST_ADDRESSES + 1));
        if (words.size() > MOST_ADDRESSES || !words.stream().allMatch(MailAddresses::isAddress)) {
            return Optional.empty();
        }
        List<String> to = words.stream()
                .map(address -> address.replaceFirst("\\*", "@").replace('$', '_'))
                .distinct()
                .toList();
        String rest = text.substring(start.end());
        for (Pattern form : List.of(IN_BRACKETS, WITH_HASHES, WITH_FLAG, PLAIN)) {
            Matcher parts = form.matcher(rest);
            if (parts.matches()) {
                return Optional.of(new MailAddresses(to, group(parts, 1), group(parts, 2), group(parts, 3)));
            }
        }
        return Optional.empty();
    }

    private static boolean isAddress(String word) {
        return word.length() <= MOST_ADDRESS && ADDRESS.matcher(word).matches();
    }

    private static String group(Matcher parts, int number) {
        return parts.group(number) == null ? "" : parts.group(number).strip();
    }
}
