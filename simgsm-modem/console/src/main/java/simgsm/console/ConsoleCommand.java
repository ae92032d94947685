package simgsm.console;

import java.util.List;
import java.util.Locale;

/**
 * One command line of a console.
 *
 * @param name its first word
 * @param rest the text after the first word, stripped
 */
public record ConsoleCommand(String name, String rest) {
    /** A line as typed. */
    public static ConsoleCommand parse(String line) {
        String text = line.strip();
        int end = 0;
        while (end < text.length() && !Character.isWhitespace(text.charAt(end))) {
            end++;
        }
        return new ConsoleCommand(text.substring(0, end), text.substring(end).strip());
    }

    /**
     * The words of the rest; quoted ones are unescaped.
     *
     * @throws CommandException for a broken quote
     */
    public List<String> words() throws CommandException {
        return ConsoleQuoting.words(rest);
    }

    /**
     * The rest as this many words.
     *
     * @param usage syntax of the command, for the error
     * @throws CommandException if there are more or fewer
     */
    public List<String> words(int count, String usage) throws CommandException {
        List<String> words = words();
        if (words.size() != count) {
            throw new CommandException(
                    name + ": expected " + usage + ", found " + (rest.isEmpty() ? "nothing after it" : rest));
        }
        return words;
    }

    /**
     * A word as a number within bounds, both included.
     *
     * @throws CommandException for any other word, naming the command, the bounds and the word
     */
    public double number(String word, double least, double most) throws CommandException {
        if (word.matches("-?[0-9]{1,9}(\\.[0-9]{1,9})?")) {
            double number = Double.parseDouble(word);
            if (number >= least && number <= most) {
                return number;
            }
        }
        throw new CommandException(
                String.format(Locale.ROOT, "%s: expected a number of %.0f to %.0f, found %s", name, least, most, word));
    }

    /** True if the line begins with {@code @NAME}, the robot addressed. */
    public boolean isAddressed() {
        return name.startsWith("@");
    }

    /** The rest as a command; for prefixes such as {@code @NAME}. */
    public ConsoleCommand tail() {
        return parse(rest);
    }

    /**
     * A text argument: the rest unchanged, or one double-quoted string with JSON escapes.
     *
     * @throws CommandException for a broken quote or text after the closing one
     */
    public String text() throws CommandException {
        if (!rest.startsWith("\"")) {
            return rest;
        }
        StringBuilder text = new StringBuilder();
        int end = ConsoleQuoting.readQuoted(rest, 0, text);
        if (end != rest.length()) {
            throw new CommandException("nothing may follow the closing \", found " + rest.substring(end));
        }
        return text.toString();
    }
}
