package simgsm.console;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The options of a program: reads command lines and prints the help. */
public final class Options {
    /** @param value name of the value in the help; null for a flag */
    private record Option(String name, String value, String help, boolean collects, boolean isOptional) {}

    private final String usage;
    private final String summary;
    private final Map<String, Option> options = new LinkedHashMap<>();
    private int maxArguments;
    private CommandTable<?> commands;

    /**
     * @param usage a command line, as {@code java -jar simgsm-phone.jar --number N [options]}
     * @param summary what it does, one or a few lines
     */
    public Options(String usage, String summary) {
        this.usage = usage;
        this.summary = summary;
    }

    /** An option with a value; the last one counts. */
    public Options value(String name, String value, String help) {
        return add(new Option(name, value, help, false, false));
    }

    /** An option whose value may be left out; it is empty then. */
    public Options optionalValue(String name, String value, String help) {
        return add(new Option(name, value, help, false, true));
    }

    /** An option with a value of which all count. */
    public Options collecting(String name, String value, String help) {
        return add(new Option(name, value, help, true, false));
    }

    /** An option without a value. */
    public Options flag(String name, String help) {
        return add(new Option(name, null, help, false, false));
    }

    /** Most arguments other than options; without this call none. */
    public Options arguments(int most) {
        maxArguments = most;
        return this;
    }

    /** Adds the console's commands to the help. */
    public Options commands(CommandTable<?> table) {
        commands = table;
        return this;
    }

    private Options add(Option option) {
        if (options.put(option.name, option) != null) {
            throw new IllegalArgumentException("option --" + option.name + " twice");
        }
        return this;
    }

    /**
     * Reads a command line; {@code --opt value} and {@code --opt=value}, {@code --} ends the options.
     *
     * @throws UsageException naming the option and what was expected
     */
    public Arguments parse(List<String> words) throws UsageException {
        Map<String, List<String>> given = new LinkedHashMap<>();
        List<String> rest = new ArrayList<>();
        boolean optionsEnded = false;
        for (int i = 0; i < words.size(); i++) {
            String word = words.get(i);
            if (optionsEnded || !word.startsWith("-") || word.equals("-")) {
                rest.add(word);
            } else if (word.equals("--")) {
                optionsEnded = true;
            } else {
                i = readOption(words, i, given);
            }
        }
        if (rest.size() > maxArguments && !given.containsKey("help") && !given.containsKey("version")) {
            throw new UsageException("unexpected argument " + rest.get(maxArguments));
        }
        return new Arguments(given, rest);
    }

    private int readOption(List<String> words, int at, Map<String, List<String>> given) throws UsageException {
        String word = words.get(at);
        int equals = word.indexOf('=');
        String name = longName(equals < 0 ? word : word.substring(0, equals));
        Option option = options.get(name);
        if (option == null && !name.equals("help") && !name.equals("version")) {
            throw new UsageException("unknown option " + word);
        }
        int next = at;
        String value = "";
        if (option == null || option.value == null) {
            if (equals >= 0) {
                throw new UsageException("--" + name + " takes no value, found " + word.substring(equals + 1));
            }
        } else if (equals >= 0) {
            value = word.substring(equals + 1);
        } else if (at + 1 < words.size() && !words.get(at + 1).startsWith("--")) {
            next = at + 1;
            value = words.get(next);
        } else if (!option.isOptional) {
            throw new UsageException("--" + name + " needs a value: " + option.value);
        }
        List<String> values = given.computeIfAbsent(name, key -> new ArrayList<>());
        if (option == null || !option.collects) {
            values.clear();
        }
        values.add(value);
        return next;
    }

    private static String longName(String word) throws UsageException {
        return switch (word) {
            case "-h" -> "help";
            case "-V" -> "version";
            default -> {
                if (!word.startsWith("--")) {
                    throw new UsageException("unknown option " + word);
                }
                yield word.substring(2);
            }
        };
    }

    /** The text that {@code --help} prints. */
    public String help() {
        StringBuilder text = new StringBuilder("Usage: " + usage + "\n\n" + summary + "\n\nOptions:\n");
        options.values().forEach(option -> describe(text, "    --" + option.name, shown(option), option.help));
        describe(text, "-h, --help", "", "print this and end");
        describe(text, "-V, --version", "", "print the version and end");
        if (commands != null) {
            text.append("\nConsole commands, with --headless:\n").append(commands.reference());
        }
        return text.toString();
    }

    private static String shown(Option option) {
        if (option.value == null) {
            return "";
        }
        return option.isOptional ? "[" + option.value + "]" : option.value;
    }

    /** Appends a name, its value and a text in two columns. */
    static void describe(StringBuilder text, String name, String value, String help) {
        String left = "  " + name + (value.isEmpty() ? "" : " " + value);
        String column = " ".repeat(30);
        text.append(left.length() < column.length() - 1 ? left + column.substring(left.length()) : left + "\n" + column)
                .append(help.replace("\n", "\n" + column))
                .append('\n');
    }
}
