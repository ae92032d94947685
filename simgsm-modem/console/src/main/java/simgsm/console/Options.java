package simgsm.console;

import java.io.InputStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The options of a program, from rows of text: reads command lines and prints the help. */
public final class Options {
    /** Suffix of an option's arguments: all values are kept, not only the last. */
    private static final String REPEATABLE = " ...";

    private final HelpRow program;
    private final Map<String, HelpRow> options = new LinkedHashMap<>();
    private int maxArguments;
    private CommandTable<?> commands;

    /**
     * @param usage a command line, as {@code java -jar simgsm-phone.jar --number N [options]}
     * @param summary its purpose, one or a few lines
     */
    public Options(String usage, String summary) {
        this(new HelpRow(usage, "", summary, ""));
    }

    private Options(HelpRow program) {
        this.program = program;
    }

    /**
     * The options of a resource: the usage and the program's purpose, then a row for each option, as {@code --name
     * VALUE} with indented lines of help, the Spanish ones after {@code es:}. {@code [VALUE]} may be left out; after
     * {@code VALUE ...} all values are kept, not only the last. A row without help is shared by programs; {@code
     * include headless} or {@code include common} are the rows of {@link HelpRow}.
     */
    public static Options read(InputStream resource) {
        List<HelpRow> rows = HelpRow.read(resource);
        return new Options(rows.get(0)).add(rows.subList(1, rows.size()));
    }

    /** Adds the options of a text with the rows of {@link #read}. */
    public Options rows(String text) {
        return add(HelpRow.parse(text));
    }

    private Options add(List<HelpRow> rows) {
        for (HelpRow row : rows) {
            if (options.put(row.name().substring(2), row) != null) {
                throw new IllegalArgumentException("option " + row.name() + " twice");
            }
        }
        return this;
    }

    /** Most arguments other than options; 0 without this call. */
    public Options arguments(int most) {
        maxArguments = most;
        return this;
    }

    /** Adds the console's commands to the help. */
    public Options commands(CommandTable<?> table) {
        commands = table;
        return this;
    }

    /**
     * Reads a command line; {@code --opt value} and {@code --opt=value}, {@code --} ends the options.
     *
     * @throws UsageException naming the option and the expected value
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
        HelpRow option = options.get(name);
        if (option == null && !name.equals("help") && !name.equals("version")) {
            throw new UsageException("unknown option " + word);
        }
        int next = at;
        String value = "";
        if (option == null || option.arguments().isEmpty()) {
            if (equals >= 0) {
                throw new UsageException("--" + name + " takes no value, found " + word.substring(equals + 1));
            }
        } else if (equals >= 0) {
            value = word.substring(equals + 1);
        } else if (at + 1 < words.size() && !words.get(at + 1).startsWith("--")) {
            next = at + 1;
            value = words.get(next);
        } else if (!option.arguments().startsWith("[")) {
            throw new UsageException("--" + name + " needs a value: " + option.arguments());
        }
        List<String> values = given.computeIfAbsent(name, key -> new ArrayList<>());
        if (option == null || !option.arguments().endsWith(REPEATABLE)) {
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
    public String help(boolean inSpanish) {
        StringBuilder text = new StringBuilder(inSpanish ? "Uso: " : "Usage: ")
                .append((program.name() + " " + program.arguments()).strip() + "\n\n" + program.help(inSpanish))
                .append(inSpanish ? "\n\nOpciones:\n" : "\n\nOptions:\n");
        options.values().forEach(option -> option.describe(text, inSpanish));
        HelpRow.shared("-h,").describe(text, inSpanish);
        HelpRow.shared("-V,").describe(text, inSpanish);
        if (commands != null) {
            text.append(inSpanish ? "\nÓrdenes de consola" : "\nConsole commands")
                    .append(inSpanish ? ", con --headless:\n" : ", with --headless:\n")
                    .append(commands.reference(inSpanish));
        }
        return text.toString();
    }
}
