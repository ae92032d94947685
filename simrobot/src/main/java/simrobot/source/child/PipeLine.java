package simrobot.source.child;

import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * One line between SimRobot and a child: a word, then {@code name=value} for each value. Texts are URL-encoded in UTF-8, so
 * that they contain no space.
 */
public record PipeLine(String word, Map<String, String> values) {
    /** Returns a line with these values, without its end. @param namesAndValues in turn */
    public static String of(String word, Object... namesAndValues) {
        StringBuilder line = new StringBuilder(word);
        for (int i = 0; i < namesAndValues.length; i += 2) {
            Object value = namesAndValues[i + 1];
            line.append(' ').append(namesAndValues[i]).append('=');
            line.append(value instanceof String text ? URLEncoder.encode(text, StandardCharsets.UTF_8) : value);
        }
        return line.toString();
    }

    /** Returns the line with decoded values; empty if it has another form. */
    public static Optional<PipeLine> parse(String line) {
        String[] parts = line.split(" ");
        Map<String, String> values = new HashMap<>();
        for (int i = 1; i < parts.length; i++) {
            int equals = parts[i].indexOf('=');
            if (equals <= 0) {
                return Optional.empty();
            }
            try {
                String value = URLDecoder.decode(parts[i].substring(equals + 1), StandardCharsets.UTF_8);
                values.put(parts[i].substring(0, equals), value);
            } catch (IllegalArgumentException malformed) {
                return Optional.empty();
            }
        }
        return parts.length == 0 ? Optional.empty() : Optional.of(new PipeLine(parts[0], values));
    }

    /** Returns a text; empty if the line has none of this name. */
    public String text(String name) {
        return values.getOrDefault(name, "");
    }

    /** @throws NumberFormatException if the line has no number of this name */
    public double number(String name) {
        // an exponent's plus is decoded to a space
        return Double.parseDouble(text(name).replace(' ', '+'));
    }

    /** Returns true if the value is 1. */
    public boolean flag(String name) {
        return text(name).equals("1");
    }
}
