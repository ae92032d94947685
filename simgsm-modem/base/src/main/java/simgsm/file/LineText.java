package simgsm.file;

/** Text from outside as a part of one printed line. */
public final class LineText {
    private static final int DELETE = 0x7f;
    private static final int LAST_CONTROL = 0x9f;
    /** Line and paragraph separators, which end a line for many readers. */
    private static final String SEPARATORS = "\u2028\u2029";

    private LineText() {}

    /** The text with control characters and line separators as JSON escapes (RFC 8259, 7). */
    public static String escaped(String text) {
        if (text.chars().noneMatch(LineText::isEscaped)) {
            return text;
        }
        StringBuilder line = new StringBuilder();
        text.chars().forEach(c -> {
            int letter = "\b\t\n\f\r".indexOf(c);
            if (letter >= 0) {
                line.append('\\').append("btnfr".charAt(letter));
            } else if (isEscaped(c)) {
                line.append(String.format("\\u%04x", c));
            } else {
                line.append((char) c);
            }
        });
        return line.toString();
    }

    private static boolean isEscaped(int c) {
        return c < ' ' || c >= DELETE && c <= LAST_CONTROL || SEPARATORS.indexOf(c) >= 0;
    }
}
