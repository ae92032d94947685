package simgsm.console;

/** Strings as JSON writes them (RFC 8259), for consoles and web pages. */
public final class JsonString {
    private static final int DELETE = 0x7f;
    private static final int LAST_CONTROL = 0x9f;
    /** Line and paragraph separators, which end a line for many readers. */
    private static final String SEPARATORS = "\u2028\u2029";

    private JsonString() {}

    /** In double quotes, in one line; control characters are escaped. */
    public static String quoted(String value) {
        StringBuilder text = new StringBuilder("\"");
        value.chars().forEach(c -> append(text, (char) c));
        return text.append('"').toString();
    }

    private static void append(StringBuilder text, char c) {
        switch (c) {
            case '"' -> text.append("\\\"");
            case '\\' -> text.append("\\\\");
            case '\n' -> text.append("\\n");
            case '\r' -> text.append("\\r");
            case '\t' -> text.append("\\t");
            case '\b' -> text.append("\\b");
            case '\f' -> text.append("\\f");
            default -> {
                boolean isControl = c < ' ' || c >= DELETE && c <= LAST_CONTROL;
                if (isControl || SEPARATORS.indexOf(c) >= 0) {
                    text.append(String.format("\\u%04x", (int) c));
                } else {
                    text.append(c);
                }
            }
        }
    }
}
