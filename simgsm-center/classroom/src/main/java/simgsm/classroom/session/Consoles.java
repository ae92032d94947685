package simgsm.classroom.session;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import simgsm.console.CommandException;
import simgsm.console.Event;
import simgsm.lesson.EventPattern;
import simgsm.lesson.LessonException;

/** The consoles of started programs by name, and the events of other sources. Any thread may add events; one thread waits. */
public final class Consoles {
    private static final System.Logger LOG = System.getLogger(Consoles.class.getName());
    private static final double WAIT_SECONDS = 20;
    private static final double MOST_WAIT_SECONDS = 600;
    private static final int END_SECONDS = 20;
    private static final Pattern WAIT = Pattern.compile("wait\\s+(.*?)(?:\\s+([0-9]+(?:\\.[0-9]+)?))?");

    /** Receives output and events; called by the threads of the consoles. */
    public interface Listener {
        /** A line of a program's output, or a command prefixed by {@code >}. */
        default void line(String name, String line) {}

        /** An event; called before a wait finds it. */
        default void event(String source, Event event) {}

        /** The user has chosen a lesson in the help of a program's window. */
        default void lessonChosen(String lesson) {}

        /**
         * A program has ended.
         *
         * @param isFault before it was ready, or with an exit status other than 0
         */
        default void ended(String name, int status, boolean isFault) {}
    }

    private final Map<String, UnreadEvents<Event>> unread = new ConcurrentHashMap<>();
    private final Map<String, ProgramConsole> consoles = new ConcurrentHashMap<>();
    private final Map<String, Event> ready = new ConcurrentHashMap<>();
    private volatile Listener listener = new Listener() {};

    public void listen(Listener next) {
        listener = next;
    }

    /** Reads the output of a newly started program. */
    public void attach(String name, Process process) {
        ready.remove(name);
        UnreadEvents<Event> events = new UnreadEvents<>();
        unread.put(name, events);
        consoles.put(name, new ProgramConsole(name, process, new ProgramConsole.Listener() {
            @Override
            public void line(String line) {
                listener.line(name, line);
                try {
                    add(name, Event.parse(line));
                } catch (CommandException e) {
                    listener.line(name, "that line is no event: " + e.getMessage());
                }
            }

            @Override
            public void ended() {
                events.end();
                try {
                    int status = process.waitFor();
                    listener.ended(name, status, !ready.containsKey(name) || status != 0);
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        }));
    }

    /** Adds an event and prints its line. */
    public void print(String source, Event event) {
        listener.line(source, event.toString());
        add(source, event);
    }

    /** Adds an event of any source. */
    public void add(String source, Event event) {
        LOG.log(System.Logger.Level.DEBUG, () -> source + ": " + event);
        if (event.name().equals("ready")) {
            ready.put(source, event);
        }
        listener.event(source, event);
        if (event.name().equals("lesson") && event.fields().containsKey("name")) {
            listener.lessonChosen(event.fields().get("name"));
        }
        unread(source).add(event);
    }

    private UnreadEvents<Event> unread(String source) {
        return unread.computeIfAbsent(source, key -> new UnreadEvents<>());
    }

    /** The event that reported a program ready. */
    public Optional<Event> ready(String name) {
        return Optional.ofNullable(ready.get(name));
    }

    /** The names of the running programs. */
    public Set<String> running() {
        return consoles.keySet().stream().filter(this::isRunning).collect(Collectors.toSet());
    }

    public boolean isRunning(String name) {
        ProgramConsole console = consoles.get(name);
        return console != null && console.process().isAlive();
    }

    /**
     * Performs a line of a script: {@code SOURCE wait EVENT [TEST]... [SECONDS]}, {@code stop PROGRAM}, or {@code PROGRAM
     * COMMAND}.
     */
    public void perform(String line) throws SessionFailure, InterruptedException {
        String[] parts = line.strip().split("\\s+", 2);
        String rest = parts.length == 2 ? parts[1] : "";
        Matcher wait = WAIT.matcher(rest);
        if (wait.matches()) {
            await(parts[0], wait.group(1), wait.group(2) == null ? WAIT_SECONDS : Double.parseDouble(wait.group(2)));
        } else if (parts[0].equals("stop")) {
            stop(rest);
        } else {
            command(parts[0], rest);
        }
    }

    private void command(String name, String command) throws SessionFailure {
        listener.line(name, "> " + command);
        try {
            console(name).command(command);
        } catch (IOException e) {
            throw new SessionFailure(name + " takes no commands: " + e.getMessage());
        }
    }

    private ProgramConsole console(String name) throws SessionFailure {
        return Optional.ofNullable(consoles.get(name))
                .orElseThrow(() -> new SessionFailure("expected a program, found " + name));
    }

    /**
     * Waits for a source's next event; drops earlier ones.
     *
     * @param wanted {@code EVENT [TEST]...}, as in a lesson's conditions
     */
    public Event await(String source, String wanted, double seconds) throws SessionFailure, InterruptedException {
        if (seconds > MOST_WAIT_SECONDS) {
            throw new SessionFailure("wait: expected at most " + (int) MOST_WAIT_SECONDS + " s, found " + seconds);
        }
        try {
            EventPattern pattern = EventPattern.parse(source + " " + wanted);
            UnreadEvents<Event> events = unread(source);
            return events.await(event -> pattern.matches(source, event, UnaryOperator.identity()), seconds)
                    .orElseThrow(() -> new SessionFailure(source + ": expected " + wanted
                            + (events.isEnded() ? ", but the program has ended" : " within " + seconds + " s")));
        } catch (LessonException e) {
            throw new SessionFailure("wait: " + e.getMessage());
        }
    }

    private void stop(String name) throws SessionFailure, InterruptedException {
        try {
            console(name).close();
        } catch (IOException e) {
            throw new SessionFailure(name + ": " + e.getMessage());
        }
        awaitEnd(name);
    }

    /** Waits for the end of a program and returns its exit status. */
    public int awaitEnd(String name) throws SessionFailure, InterruptedException {
        Process process = console(name).process();
        if (!process.waitFor(END_SECONDS, TimeUnit.SECONDS)) {
            throw new SessionFailure(name + ": expected to end within " + END_SECONDS + " s");
        }
        return process.exitValue();
    }
}
