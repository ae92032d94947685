package simgsm.console;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.event.EventForm;

/**
 * The headless console: reads commands and prints events, one per line. Any thread may emit; one thread runs the
 * commands.
 *
 * <p>The console performs {@code wait EVENT [key=value...] [SECONDS]} and {@code quit}; all other commands are
 * performed by the program's {@link Commands}, most of them by a {@link CommandTable}.
 */
public final class Console implements AutoCloseable {
    /** Performs the commands of a program. An exception is printed as an error, and the program continues. */
    public interface Commands {
        void perform(ConsoleCommand command) throws CommandException;

        /** True if a command may begin with {@code @NAME}, which wait and quit then ignore. */
        default boolean areAddressed() {
            return false;
        }
    }

    /** Source of command lines. */
    interface Lines {
        /**
         * The next line; null at the end.
         *
         * @throws CommandException if it is no text; further lines can be read
         */
        String next() throws IOException, CommandException;
    }

    /** Delays the reading of the next command while too much output waits. */
    private interface Room {
        void await() throws InterruptedException;
    }

    private static final double DEFAULT_WAIT_SECONDS = 10;
    private static final double MAX_WAIT_SECONDS = 1e6;
    private static final int MAX_ERROR_CHARACTERS = 2_000;

    private final Consumer<Event> printer;
    private final Runnable ending;
    private final Room room;
    private final EventBuffer log = new EventBuffer();
    private List<Event> beforeReady = new ArrayList<>();
    private volatile boolean failed;

    /** A console that prints on the thread that calls {@link #emit}. */
    public Console(PrintStream out) {
        this(
                event -> {
                    out.print(event + "\n");
                    out.flush();
                },
                out::flush,
                () -> {});
    }

    private Console(Consumer<Event> printer, Runnable ending, Room room) {
        this.printer = printer;
        this.ending = ending;
        this.room = room;
    }

    /**
     * A console on standard output that prints on its own thread, so that {@link #emit} never blocks. If standard
     * output cannot be written (full disk, closed reader), the program ends with status 74.
     */
    public static Console onStandardOutput() {
        EventOutputQueue queue = new EventOutputQueue(StandardOutput.STREAM, Console::endWithoutOutput);
        return new Console(queue::print, queue::close, queue::awaitRoom);
    }

    private static void endWithoutOutput() {
        StandardOutput.STREAM.hasFailed(System.err);
        FatalError.exit(ExitStatus.INPUT_OUTPUT);
    }

    /** Prints the waiting events. */
    @Override
    public void close() {
        ending.run();
    }

    /** Prints {@code ready}, the first line, then the events emitted earlier. */
    public synchronized void ready(Event ready) {
        List<Event> waiting = beforeReady;
        beforeReady = null;
        emit(ready);
        waiting.forEach(this::emit);
    }

    /** Prints an event; before {@link #ready} it is kept. */
    public synchronized void emit(Event event) {
        if (beforeReady != null) {
            beforeReady.add(event);
            return;
        }
        log.add(event);
        printer.accept(event);
    }

    /** Prints the event of a record; nothing if its class declares no line. */
    public void tell(Object record) {
        if (EventForm.of(record).isPresent()) {
            emit(Event.from(record));
        }
    }

    /** Prints the rows of a list and {@code end of= count=}. */
    public void emitList(String name, List<Event> rows) {
        rows.forEach(this::emit);
        emit(Event.of("end").with("of", name).with("count", rows.size()));
    }

    /** Prints {@code error text=}; a quoted long line is shortened to its beginning. */
    public void error(String text) {
        boolean isLong = text.codePointCount(0, text.length()) > MAX_ERROR_CHARACTERS;
        String shown = isLong ? text.substring(0, text.offsetByCodePoints(0, MAX_ERROR_CHARACTERS)) + " ..." : text;
        emit(Event.of("error").with("text", shown));
    }

    /**
     * Performs the commands of one input until {@code quit} or its end.
     *
     * @return true if it ended with {@code quit}
     */
    public boolean run(BufferedReader input, Commands commands) throws IOException, InterruptedException {
        return run((Lines) input::readLine, commands);
    }

    /** As above, with lines that may be no text, each an error. */
    boolean run(Lines input, Commands commands) throws IOException, InterruptedException {
        for (Optional<ConsoleCommand> next = read(input); next.isPresent(); next = read(input)) {
            ConsoleCommand command = next.get();
            ConsoleCommand meant = commands.areAddressed() && command.isAddressed() ? command.tail() : command;
            if (meant.name().equals("quit") && meant.rest().isEmpty()) {
                return true;
            }
            if (!command.name().isEmpty()) {
                perform(command, meant, commands);
            }
            room.await();
        }
        return false;
    }

    /** The next command; empty at the end. */
    private Optional<ConsoleCommand> read(Lines input) throws IOException {
        while (true) {
            try {
                return Optional.ofNullable(input.next()).map(ConsoleCommand::parse);
            } catch (CommandException e) {
                error(e.getMessage());
            }
        }
    }

    /** @param meant the command without {@code @NAME} */
    private void perform(ConsoleCommand command, ConsoleCommand meant, Commands commands) throws InterruptedException {
        try {
            if (meant.name().equals("wait")) {
                await(meant);
            } else if (meant.name().equals("quit")) {
                throw new CommandException("quit takes nothing, found " + meant.rest());
            } else {
                commands.perform(command);
            }
        } catch (CommandException e) {
            error(e.getMessage());
        }
    }

    private void await(ConsoleCommand command) throws CommandException, InterruptedException {
        List<String> words = new ArrayList<>(command.words());
        double seconds = DEFAULT_WAIT_SECONDS;
        if (words.size() > 1 && words.get(words.size() - 1).indexOf('=') < 0) {
            seconds = seconds(words.remove(words.size() - 1));
        }
        if (words.isEmpty() || words.get(0).indexOf('=') >= 0) {
            throw new CommandException("wait: expected EVENT [key=value...] [SECONDS], found "
                    + (words.isEmpty() ? "nothing after it" : command.rest()));
        }
        Event wanted = new Event(words.get(0), fields(words.subList(1, words.size())));
        if (!log.await(wanted, (long) (seconds * 1e9))) {
            failed = true;
            error("wait: no " + wanted + " within " + plain(seconds) + " s");
            log.skip();
        }
    }

    private static double seconds(String word) throws CommandException {
        if (word.matches("[0-9]{1,7}(\\.[0-9]{1,9})?|\\.[0-9]{1,9}")) {
            double seconds = Double.parseDouble(word);
            if (seconds <= MAX_WAIT_SECONDS) {
                return seconds;
            }
        }
        throw new CommandException("wait: expected key=value or a number of seconds, found " + word);
    }

    private static Map<String, String> fields(List<String> words) throws CommandException {
        Map<String, String> fields = new LinkedHashMap<>();
        for (String word : words) {
            int equals = word.indexOf('=');
            if (equals <= 0) {
                throw new CommandException("wait: expected key=value, found " + word);
            }
            fields.put(word.substring(0, equals), word.substring(equals + 1));
        }
        return fields;
    }

    private static String plain(double seconds) {
        return seconds == Math.rint(seconds) ? Long.toString((long) seconds) : Double.toString(seconds);
    }

    /** Sets the exit status to {@link ExitStatus#FAILED}. */
    public void fail() {
        failed = true;
    }

    /** {@link ExitStatus#FAILED} once a wait has timed out, else {@link ExitStatus#OK}. */
    public int exitStatus() {
        return failed ? ExitStatus.FAILED : ExitStatus.OK;
    }
}
