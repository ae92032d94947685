package simgsm.console;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The commands of a program's console: for each its name, its arguments, what it does, and the method that performs it.
 * A table is made once, as a constant, and prints itself as a page of reference.
 *
 * @param <T> the object that performs the commands
 */
public final class CommandTable<T> {
    /**
     * Performs one command; a method such as {@code void dial(ConsoleCommand command)} of {@code T} is one.
     *
     * @param <T> the object that performs it
     */
    public interface Action<T> {
        void perform(T target, ConsoleCommand command) throws CommandException;
    }

    private record Row<T>(String arguments, String help, Action<T> action) {}

    private final Map<String, Row<T>> rows = new LinkedHashMap<>();

    /** An empty table, to which {@link #add} adds. */
    public CommandTable() {}

    /**
     * Adds a command.
     *
     * @param arguments as in a usage line, {@code NUMBER TEXT}; empty for a command that takes none: the table refuses any
     * @param help what it does, in one or a few lines
     */
    public CommandTable<T> add(String name, String arguments, String help, Action<T> action) {
        if (rows.put(name, new Row<>(arguments, help, action)) != null) {
            throw new IllegalArgumentException("command " + name + " twice");
        }
        return this;
    }

    /** Performs the command of this name; an unknown name is an error that lists the known ones. */
    public void perform(T target, ConsoleCommand command) throws CommandException {
        Row<T> row = rows.get(command.name());
        if (row == null) {
            throw new CommandException("unknown command " + command.name() + ", expected "
                    + String.join(", ", rows.keySet()) + ", wait or quit");
        }
        if (row.arguments.isEmpty()) {
            command.words(0, "nothing after it");
        }
        row.action.perform(target, command);
    }

    /** As {@link #perform}, where the core runs on another thread: no answer in time is an error like any other. */
    public void performAsking(T target, ConsoleCommand command) throws CommandException {
        try {
            perform(target, command);
        } catch (IllegalStateException noAnswer) {
            throw new CommandException(command.name() + ": " + noAnswer.getMessage());
        }
    }

    /** One entry a command, {@code name arguments} and what it does; {@code wait} and {@code quit} come last. */
    public String reference() {
        StringBuilder text = new StringBuilder();
        rows.forEach((name, row) -> Options.describe(text, name, row.arguments, row.help));
        Options.describe(
                text,
                "wait",
                "EVENT [key=value...] [SECONDS]",
                "waits for an event with these fields; after the seconds (10) an error, and exit status 1");
        Options.describe(text, "quit", "", "ends the program");
        return text.toString();
    }
}
