package simgsm.console;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;

/** Values on console lines: unquoted if every character is plain, else in double quotes with JSON escapes. */
final class ConsoleQuoting {
    private static final String BARE_PUNCTUATION = "+.,:/*#_-";

    private ConsoleQuoting() {}

    /** The value as printed on an event line. */
    static String write(String value) {
        if (!value.isEmpty() && value.chars().allMatch(ConsoleQuoting::isBare)) {
            return value;
        }
        return JsonString.quoted(value);
    }

    private static boolean isBare(int c) {
        return c >= 'A' && c <= 'Z' || c >= 'a' && c <= 'z' || c >= '0' && c <= '9' || BARE_PUNCTUATION.indexOf(c) >= 0;
    }

    /**
     * Splits a line at blanks outside quotes; quoted parts are unescaped, also after {@code key=}.
     *
     * @throws CommandException for an unfinished quote or an unknown escape
     */
    static List<String> words(String line) throws CommandException {
        List<String> words = new ArrayList<>();
        int at = 0;
        while (at < line.length()) {
            if (Character.isWhitespace(line.charAt(at))) {
                at++;
            } else {
                StringBuilder word = new StringBuilder();
                at = readWord(line, at, word);
                words.add(word.toString());
            }
        }
        return words;
    }

    private static int readWord(String line, int start, StringBuilder word) throws CommandException {
        int at = start;
        while (at < line.length() && !Character.isWhitespace(line.charAt(at))) {
            if (line.charAt(at) == '"') {
                at = readQuoted(line, at, word);
            } else {
                word.append(line.charAt(at++));
            }
        }
        return at;
    }

    /** Appends the string with its opening quote at {@code open}; returns the index after its closing quote. */
    static int readQuoted(String line, int open, StringBuilder text) throws CommandException {
        int start = text.length();
        int at = open + 1;
        while (at < line.length() && line.charAt(at) != '"') {
            if (line.charAt(at) == '\\') {
                at = readEscape(line, at + 1, text);
            } else {
                text.append(line.charAt(at++));
            }
        }
        if (at >= line.length()) {
            throw new CommandException("a closing \" is missing");
        }
        checkSurrogates(text.substring(start));
        return at + 1;
    }

    /** Refuses half of a surrogate pair, which would reach the far end as a question mark. */
    private static void checkSurrogates(String text) throws CommandException {
        OptionalInt half = text.codePoints()
                .filter(character -> Character.getType(character) == Character.SURROGATE)
                .findFirst();
        if (half.isPresent()) {
            throw new CommandException(String.format(
                    "\\u%04x is half of a character, expected \\ud800 to \\udbff directly before \\udc00 to \\udfff",
                    half.getAsInt()));
        }
    }

    private static int readEscape(String line, int at, StringBuilder text) throws CommandException {
        char escape = at < line.length() ? line.charAt(at) : '\0';
        int plain = "\"\\/bfnrt".indexOf(escape);
        if (plain >= 0) {
            text.append("\"\\/\b\f\n\r\t".charAt(plain));
            return at + 1;
        }
        if (escape == 'u' && at + 5 <= line.length()) {
            String digits = line.substring(at + 1, at + 5);
            if (!digits.matches("[0-9A-Fa-f]{4}")) {
                throw new CommandException("\\u expects four hexadecimal digits, not " + digits);
            }
            text.append((char) Integer.parseInt(digits, 16));
            return at + 5;
        }
        throw new CommandException(
                "unknown escape \\" + escape + ", expected one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\uXXXX");
    }
}
