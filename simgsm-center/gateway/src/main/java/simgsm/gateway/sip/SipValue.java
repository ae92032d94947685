package simgsm.gateway.sip;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * A value of a header field with its parameters, such as an address or a Via (RFC 3261, 20). Without angle brackets,
 * what follows the first semicolon are parameters of the field.
 *
 * @param main the URI, or the text before the parameters
 * @param parameters by name in lower case; an empty text for one without a value
 */
record SipValue(String main, Map<String, String> parameters) {
    static SipValue parse(String text) {
        int open = indexOutsideQuotes(text, '<');
        int close = open < 0 ? -1 : text.indexOf('>', open);
        if (close > 0) {
            return new SipValue(text.substring(open + 1, close).strip(), parameters(text.substring(close + 1)));
        }
        int end = indexOutsideQuotes(text, ';');
        return end < 0
                ? new SipValue(text.strip(), Map.of())
                : new SipValue(text.substring(0, end).strip(), parameters(text.substring(end)));
    }

    private static Map<String, String> parameters(String text) {
        Map<String, String> parameters = new LinkedHashMap<>();
        for (String part : split(text, ';')) {
            int equals = part.indexOf('=');
            String name = (equals < 0 ? part : part.substring(0, equals)).strip();
            if (!name.isEmpty()) {
                String value =
                        equals < 0 ? "" : unquoted(part.substring(equals + 1).strip());
                parameters.putIfAbsent(name.toLowerCase(Locale.ROOT), value);
            }
        }
        return parameters;
    }

    /** The parts of a list, separators within quotes and angle brackets apart; without blanks around them. */
    static List<String> split(String text, char separator) {
        List<String> parts = new ArrayList<>();
        int from = 0;
        boolean isQuoted = false;
        int depth = 0;
        for (int i = 0; i <= text.length(); i++) {
            char c = i == text.length() ? separator : text.charAt(i);
            if (i == text.length() || c == separator && !isQuoted && depth == 0) {
                parts.add(text.substring(from, i).strip());
                from = i + 1;
            } else if (c == '"' && (i == 0 || text.charAt(i - 1) != '\\')) {
                isQuoted = !isQuoted;
            } else if (!isQuoted) {
                depth += c == '<' ? 1 : c == '>' ? -1 : 0;
            }
        }
        return parts;
    }

    private static int indexOutsideQuotes(String text, char wanted) {
        boolean isQuoted = false;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c == '"') {
                isQuoted = !isQuoted;
            } else if (c == wanted && !isQuoted) {
                return i;
            }
        }
        return -1;
    }

    static String unquoted(String text) {
        boolean isQuoted = text.length() >= 2 && text.startsWith("\"") && text.endsWith("\"");
        return isQuoted ? text.substring(1, text.length() - 1) : text;
    }

    Optional<String> parameter(String name) {
        return Optional.ofNullable(parameters.get(name));
    }

    String tag() {
        return parameters.getOrDefault("tag", "");
    }

    /** The user part of a sip URI; empty for another URI, or without a user. */
    String user() {
        int at = main.indexOf('@');
        return main.toLowerCase(Locale.ROOT).startsWith("sip:") && at > 0
                ? main.substring("sip:".length(), at).split("[:;]", 2)[0]
                : "";
    }
}
