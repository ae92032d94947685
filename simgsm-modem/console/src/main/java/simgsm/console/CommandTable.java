package simgsm.console;

import java.io.InputStream;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The commands of a program's console: name, arguments, help and method of each. A table is a constant and prints
 * itself as a page of reference.
 *
 * @param <T> the object that performs the commands
 */
public final class CommandTable<T> {
    /**
     * Performs one command; for example a method {@code void dial(ConsoleCommand command)} of {@code T}.
     *
     * @param <T> the object that performs it
     */
    public interface Action<T> {
        void perform(T target, ConsoleCommand command) throws CommandException;
    }

    private final Map<String, HelpRow> rows = new LinkedHashMap<>();
    private final Map<String, Action<T>> actions = new LinkedHashMap<>();

    /**
     * A table without actions; {@link #add} sets them.
     *
     * @param resource a row for each command: its name and arguments, then indented lines of help, the Spanish ones
     *     after {@code es:}. A command without declared arguments refuses any
     */
    public CommandTable(InputStream resource) {
        this(HelpRow.read(resource));
    }

    CommandTable(List<HelpRow> help) {
        help.forEach(row -> rows.put(row.name(), row));
    }

    /** Sets the action of a command, which must have a row. */
    public CommandTable<T> add(String name, Action<T> action) {
        if (!rows.containsKey(name) || actions.put(name, action) != null) {
            throw new IllegalArgumentException("command " + name + " twice, or without a row");
        }
        return this;
    }

    /** Performs the command of this name; an unknown name is an error that lists the known ones. */
    public void perform(T target, ConsoleCommand command) throws CommandException {
        HelpRow row = rows.get(command.name());
        if (row == null) {
            throw new CommandException("unknown command " + command.name() + ", expected "
                    + String.join(", ", rows.keySet()) + ", wait or quit");
        }
        if (row.arguments().isEmpty()) {
            command.words(0, "nothing after it");
        }
        actions.get(command.name()).perform(target, command);
    }

    /** As {@link #perform}, for a core on another thread: a missing answer is an error like any other. */
    public void performAsking(T target, ConsoleCommand command) throws CommandException {
        try {
            perform(target, command);
        } catch (IllegalStateException noAnswer) {
            throw new CommandException(command.name() + ": " + noAnswer.getMessage());
        }
    }

    /** One entry per command, {@code name arguments} and its help; {@code wait} and {@code quit} are the last. */
    String reference(boolean inSpanish) {
        StringBuilder text = new StringBuilder();
        rows.values().forEach(row -> row.describe(text, inSpanish));
        HelpRow.shared("wait").describe(text, inSpanish);
        HelpRow.shared("quit").describe(text, inSpanish);
        return text.toString();
    }
}
