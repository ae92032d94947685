package simrobot.world;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;

/** One line of a world file, split into words; a word in double quotes may contain blanks and {@code \"}. */
final class LineTokens {
    /** Coordinates beyond a million kilometres are errors of the file. */
    private static final double MAX_MILLIMETERS = 1e12;

    private final String source;
    private final int line;
    private final List<String> words = new ArrayList<>();
    private int next;

    LineTokens(String source, int line, String text) throws WorldFormatException {
        this.source = source;
        this.line = line;
        int at = skipBlanks(text, 0);
        while (at < text.length()) {
            at = skipBlanks(text, text.charAt(at) == '"' ? quoted(text, at + 1) : bare(text, at));
        }
    }

    boolean hasMore() {
        return next < words.size();
    }

    /** The next word without consuming it; requires {@link #hasMore}. */
    String peek() {
        return words.get(next);
    }

    String word(String expected) throws WorldFormatException {
        if (!hasMore()) {
            throw fault("the end of the line", expected);
        }
        return words.get(next++);
    }

    /** The next word as a finite number. */
    double number(String expected) throws WorldFormatException {
        String word = word(expected);
        try {
            double value = Double.parseDouble(word);
            if (Math.abs(value) <= MAX_MILLIMETERS && isDecimal(word)) {
                return value;
            }
        } catch (NumberFormatException notANumber) {
            // reported below
        }
        throw fault('"' + word + '"', expected);
    }

    /**
     * Converts millimetres to metres, rounded once from the decimal text, so that reading and writing a map loses
     * nothing.
     */
    double meters(String what) throws WorldFormatException {
        number(what + " in mm");
        return thousandth(words.get(next - 1));
    }

    /** @throws NumberFormatException if it is no decimal number */
    static double thousandth(String decimal) {
        boolean scaled = decimal.indexOf('e') >= 0 || decimal.indexOf('E') >= 0;
        return scaled ? new BigDecimal(decimal).movePointLeft(3).doubleValue() : Double.parseDouble(decimal + "e-3");
    }

    double radians(String what) throws WorldFormatException {
        return Math.toRadians(number(what + " in degrees"));
    }

    void end() throws WorldFormatException {
        if (hasMore()) {
            throw fault('"' + words.get(next) + '"', "the end of the line");
        }
    }

    WorldFormatException fault(String found, String expected) {
        return new WorldFormatException(source, line, found, expected);
    }

    /** Excludes "1f", "0x1p3" and "NaN", which Double.parseDouble accepts. */
    private static boolean isDecimal(String word) {
        for (int i = 0; i < word.length(); i++) {
            if ("0123456789+-.eE".indexOf(word.charAt(i)) < 0) {
                return false;
            }
        }
        return true;
    }

    private static int skipBlanks(String text, int from) {
        int at = from;
        while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
            at++;
        }
        return at;
    }

    private int bare(String text, int from) {
        int at = from;
        while (at < text.length() && !Character.isWhitespace(text.charAt(at))) {
            at++;
        }
        words.add(text.substring(from, at));
        return at;
    }

    private int quoted(String text, int from) throws WorldFormatException {
        StringBuilder word = new StringBuilder();
        int at = from;
        while (at < text.length() && text.charAt(at) != '"') {
            if (text.charAt(at) == '\\' && at + 1 < text.length()) {
                at++;
            }
            word.append(text.charAt(at++));
        }
        if (at >= text.length()) {
            throw fault("a quote that is not closed", "\"");
        }
        words.add(word.toString());
        return at + 1;
    }
}
