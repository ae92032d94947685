package blackbox;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** An event line as an outsider reads it: a name, then {@code key=value}, values bare or JSON strings. */
public record ConsoleEvent(String name, Map<String, String> fields) {
    private static final String BARE = "[A-Za-z0-9+.,:/*#_-]+";
    private static final String STRING = "\"(?:[^\"\\\\]|\\\\.)*\"";
    private static final Pattern FIELD = Pattern.compile(" ([a-z0-9-]+)=(" + BARE + "|" + STRING + ")");
    private static final Pattern LINE = Pattern.compile("([a-z-]+)((?:" + FIELD.pattern() + ")*)");
    private static final Pattern ESCAPE = Pattern.compile("\\\\(u[0-9a-fA-F]{4}|.)");

    /** Reads a line by the grammar of the specification; IllegalArgumentException if it breaks it. */
    public static ConsoleEvent parse(String line) {
        Matcher whole = LINE.matcher(line);
        if (!whole.matches()) {
            throw new IllegalArgumentException("not an event line: " + line);
        }
        Map<String, String> fields = new LinkedHashMap<>();
        Matcher field = FIELD.matcher(whole.group(2));
        while (field.find()) {
            fields.put(field.group(1), unquoted(field.group(2)));
        }
        return new ConsoleEvent(whole.group(1), fields);
    }

    private static String unquoted(String value) {
        if (!value.startsWith("\"")) {
            return value;
        }
        return ESCAPE.matcher(value.substring(1, value.length() - 1))
                .replaceAll(match -> Matcher.quoteReplacement(character(match.group(1))));
    }

    private static String character(String escape) {
        return switch (escape.charAt(0)) {
            case 'u' -> Character.toString((char) Integer.parseInt(escape.substring(1), 16));
            case 'n' -> "\n";
            case 'r' -> "\r";
            case 't' -> "\t";
            case 'b' -> "\b";
            case 'f' -> "\f";
            default -> escape;
        };
    }

    public String field(String key) {
        String value = fields.get(key);
        if (value == null) {
            throw new AssertionError("no field " + key + " in " + this);
        }
        return value;
    }

    public double number(String key) {
        return Double.parseDouble(field(key));
    }

    public boolean matches(String expectedName, Map<String, String> expectedFields) {
        return name.equals(expectedName) && fields.entrySet().containsAll(expectedFields.entrySet());
    }
}
