package blackbox;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simgsm.classroom.session.ProgramConsole;
import simgsm.classroom.session.UnreadEvents;

/** One of the programs as a process of its own, driven over its console. Every line must parse as an event. */
public final class RunningProgram implements AutoCloseable {
    /** How long anything may take before the test fails; a guard against hanging, no statement about speed. */
    public static final int PATIENCE_SECONDS = 60;

    private final String name;
    private final Process process;
    private final ProgramConsole console;
    private final Path log;
    private final List<String> transcript = new ArrayList<>();
    private final List<ConsoleEvent> events = new ArrayList<>();
    private final UnreadEvents<ConsoleEvent> unread = new UnreadEvents<>();

    /** @param environment added to the tests' own, DISPLAY taken away */
    public RunningProgram(String name, List<String> command, Path folder, Map<String, String> environment)
            throws IOException {
        this.name = name;
        this.log = folder.resolve(name + ".log");
        ProcessBuilder builder = new ProcessBuilder(command).redirectError(log.toFile());
        builder.directory(Dist.root().toFile());
        builder.environment().remove("DISPLAY");
        builder.environment().putAll(environment);
        this.process = builder.start();
        this.console = new ProgramConsole(name, process, new ProgramConsole.Listener() {
            @Override
            public void line(String line) {
                add(line);
            }

            @Override
            public void ended() {
                unread.end();
            }
        });
    }

    private synchronized void add(String line) {
        transcript.add(line);
        ConsoleEvent event = ConsoleEvent.parse(line);
        events.add(event);
        unread.add(event);
    }

    /** Types a line. */
    public RunningProgram say(String line) {
        try {
            console.command(line);
            synchronized (this) {
                transcript.add("> " + line);
            }
            return this;
        } catch (IOException e) {
            throw new AssertionError(name + " takes no more input: " + this, e);
        }
    }

    /** Ends its standard input. */
    public void endInput() throws IOException {
        console.close();
    }

    /**
     * Waits for an event from the last match on; events in between are passed over.
     *
     * @param keysAndValues fields that must stand in it, as key, value, key, value
     */
    public ConsoleEvent expect(String event, String... keysAndValues) {
        return await(event, fields(keysAndValues), Set.of());
    }

    /** Like {@link #expect}, but the next event of this name must be the one with these fields. */
    public ConsoleEvent expectNext(String event, String... keysAndValues) {
        Map<String, String> fields = fields(keysAndValues);
        ConsoleEvent found = await(event, Map.of(), Set.of());
        if (!found.matches(event, fields)) {
            throw new AssertionError("expected " + event + " " + fields + " next, found " + found + "\n" + this);
        }
        return found;
    }

    /** Like {@link #expect}, but none of the named events may come before it. */
    public ConsoleEvent expectBefore(Set<String> forbidden, String event, String... keysAndValues) {
        return await(event, fields(keysAndValues), forbidden);
    }

    private ConsoleEvent await(String event, Map<String, String> fields, Set<String> forbidden) {
        return await(event, fields, forbidden, candidate -> {});
    }

    /** @param seen receives the events that are passed over, and the match */
    private ConsoleEvent await(
            String event, Map<String, String> fields, Set<String> forbidden, Consumer<ConsoleEvent> seen) {
        try {
            ConsoleEvent found = unread.await(
                            candidate -> {
                                seen.accept(candidate);
                                return candidate.matches(event, fields) || forbidden.contains(candidate.name());
                            },
                            PATIENCE_SECONDS)
                    .orElseThrow(
                            () -> new AssertionError(name + (unread.isEnded() ? " ended without " : " did not say ")
                                    + event + " " + fields + "\n" + this));
            if (!found.matches(event, fields)) {
                throw new AssertionError("expected " + event + " " + fields + ", but before it " + found + "\n" + this);
            }
            return found;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError("interrupted", e);
        }
    }

    /** Like {@link #expect}; returns the events passed over too, the match last. */
    public List<ConsoleEvent> expectAll(String event, String... keysAndValues) {
        List<ConsoleEvent> seen = new ArrayList<>();
        await(event, fields(keysAndValues), Set.of(), seen::add);
        return seen;
    }

    /** The first event of this name among all that have come, wherever the last match was. */
    public synchronized ConsoleEvent said(String event) {
        return events.stream()
                .filter(candidate -> candidate.name().equals(event))
                .findFirst()
                .orElseThrow(() -> new AssertionError(name + " has not said " + event + "\n" + this));
    }

    /** All events of this name that have come. */
    public synchronized List<ConsoleEvent> allSaid(String event) {
        return events.stream()
                .filter(candidate -> candidate.name().equals(event))
                .toList();
    }

    private static Map<String, String> fields(String... keysAndValues) {
        Map<String, String> fields = new HashMap<>();
        for (int i = 0; i < keysAndValues.length; i += 2) {
            fields.put(keysAndValues[i], keysAndValues[i + 1]);
        }
        return fields;
    }

    /** Asks and waits for the answer; what was printed before the question is passed over. */
    public ConsoleEvent ask(String command, String answer) {
        unread.clear();
        say(command);
        return expect(answer);
    }

    /** Says {@code quit} and returns the exit status. */
    public int quit() throws InterruptedException {
        say("quit");
        return awaitExit();
    }

    public int awaitExit() throws InterruptedException {
        if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            throw new AssertionError(name + " does not end\n" + this);
        }
        return process.exitValue();
    }

    /** Kills it without a chance to say goodbye. */
    public void kill() throws InterruptedException {
        process.destroyForcibly().waitFor();
    }

    /** Asks the process to end by a signal. */
    public void terminate() {
        process.destroy();
    }

    public long pid() {
        return process.pid();
    }

    public String name() {
        return name;
    }

    public String log() throws IOException {
        return Files.readString(log);
    }

    @Override
    public void close() {
        process.destroyForcibly()
                .onExit()
                .orTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS)
                .join();
    }

    /** What was said on both sides, and the end of its log. */
    @Override
    public synchronized String toString() {
        String logged;
        try (Stream<String> lines = Files.lines(log)) {
            List<String> all = lines.toList();
            logged = String.join("\n    ", all.subList(Math.max(0, all.size() - 40), all.size()));
        } catch (IOException e) {
            logged = "no log: " + e.getMessage();
        }
        return "--- " + name + "\n"
                + transcript.stream().map(line -> "  " + line).collect(Collectors.joining("\n")) + "\n--- its log\n    "
                + logged;
    }
}
