package simgsm.modem.at;

import java.util.Locale;

/**
 * Splits a command line into its commands (V.250, 5.2 to 5.4): basic commands follow each other directly, extended
 * ones end with a semicolon. Blanks count only between quotation marks. A fault ends the line; earlier commands of
 * the line have been performed then.
 */
final class AtLineParser {
    /** Signs before AT are passed over (V.250, 5.2.1), as the +++ of a client that does not know the modem's mode. */
    static final String BEFORE_PREFIX = "^[^A-Za-z0-9]+(?=[Aa][Tt])";

    private static final String EXTENDED = "+*^$#%";
    private static final String NAME_SIGNS = "!%-./:_";

    private final String line;
    private int at;

    /** @param line after the letters AT */
    AtLineParser(String line) {
        this.line = line;
    }

    boolean hasNext() {
        while (at < line.length() && (line.charAt(at) == ' ' || line.charAt(at) == ';')) {
            at++;
        }
        return at < line.length();
    }

    /** @throws AtException with ERROR if no command follows */
    AtCommand next() throws AtException {
        char first = line.charAt(at);
        if (EXTENDED.indexOf(first) >= 0) {
            return extended();
        }
        if (first == '&' && at + 1 < line.length() && isLetter(line.charAt(at + 1))) {
            at += 2;
            return new AtCommand("&" + upper(line.charAt(at - 1)), AtCommand.Form.EXECUTE, number());
        }
        if (!isLetter(first)) {
            throw new AtException(AtResult.ERROR);
        }
        at++;
        return basic(upper(first));
    }

    private AtCommand basic(char letter) {
        String parameters = switch (letter) {
            case 'D' -> dialString();
            case 'S' -> register();
            default -> number();
        };
        return new AtCommand(String.valueOf(letter), AtCommand.Form.EXECUTE, parameters);
    }

    /** To the semicolon, which is included, or the end of the line. */
    private String dialString() {
        int start = at;
        at = endOfParameters();
        if (at < line.length()) {
            at++;
        }
        return line.substring(start, at).strip();
    }

    private String register() {
        StringBuilder text = new StringBuilder(number());
        skipBlanks();
        if (at < line.length() && line.charAt(at) == '?') {
            at++;
            text.append('?');
        } else if (at < line.length() && line.charAt(at) == '=') {
            at++;
            text.append('=').append(number());
        }
        return text.toString();
    }

    private String number() {
        skipBlanks();
        int start = at;
        while (at < line.length() && line.charAt(at) >= '0' && line.charAt(at) <= '9') {
            at++;
        }
        return line.substring(start, at);
    }

    private AtCommand extended() throws AtException {
        int start = at++;
        while (at < line.length() && isNameSign(line.charAt(at))) {
            at++;
        }
        String name = line.substring(start, at).toUpperCase(Locale.ROOT);
        skipBlanks();
        int begin = at;
        at = endOfParameters();
        String rest = line.substring(begin, at).strip();
        if (name.length() == 1) {
            throw new AtException(AtResult.ERROR);
        }
        if (rest.isEmpty()) {
            return new AtCommand(name, AtCommand.Form.EXECUTE, "");
        }
        if (rest.equals("?")) {
            return new AtCommand(name, AtCommand.Form.READ, "");
        }
        if (rest.charAt(0) != '=') {
            throw new AtException(AtResult.ERROR);
        }
        String parameters = rest.substring(1).strip();
        return parameters.equals("?")
                ? new AtCommand(name, AtCommand.Form.TEST, "")
                : new AtCommand(name, AtCommand.Form.SET, parameters);
    }

    /** The next semicolon outside quotation marks, or the end of the line. */
    private int endOfParameters() {
        boolean quoted = false;
        int end = at;
        while (end < line.length() && (quoted || line.charAt(end) != ';')) {
            quoted ^= line.charAt(end) == '"';
            end++;
        }
        return end;
    }

    private void skipBlanks() {
        while (at < line.length() && line.charAt(at) == ' ') {
            at++;
        }
    }

    private static boolean isLetter(char character) {
        return character >= 'A' && character <= 'Z' || character >= 'a' && character <= 'z';
    }

    private static boolean isNameSign(char character) {
        return isLetter(character) || character >= '0' && character <= '9' || NAME_SIGNS.indexOf(character) >= 0;
    }

    private static char upper(char letter) {
        return Character.toUpperCase(letter);
    }
}
