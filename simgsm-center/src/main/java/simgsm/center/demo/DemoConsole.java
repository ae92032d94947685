package simgsm.center.demo;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import simgsm.console.CommandException;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;

/** The console of one program of the demo: commands go in, events come out and into the transcript. */
final class DemoConsole {
    private final String name;
    private final Process process;
    private final OutputStream commands;
    private final DemoTranscript transcript;
    private final ArrayDeque<Event> unread = new ArrayDeque<>();
    private boolean ended;

    DemoConsole(String name, Process process, DemoTranscript transcript) {
        this.name = name;
        this.process = process;
        this.commands = process.getOutputStream();
        this.transcript = transcript;
        Thread reader = new Thread(this::read, "console of " + name);
        reader.setDaemon(true);
        reader.start();
    }

    /** Enters a command and adds it to the transcript. */
    void command(String line) throws DemoFailure {
        transcript.line(name, "> " + line);
        try {
            commands.write((line + "\n").getBytes(StandardCharsets.UTF_8));
            commands.flush();
        } catch (IOException e) {
            throw new DemoFailure(name + " takes no commands: " + e.getMessage());
        }
    }

    /** Waits for the next event of this name that holds these fields, "key=value". Earlier events are skipped. */
    Event await(int seconds, String event, String... fields) throws DemoFailure, InterruptedException {
        return await(seconds, event, candidate -> holds(candidate, fields), String.join(" ", fields));
    }

    Event await(int seconds, String event, Predicate<Event> wanted, String description)
            throws DemoFailure, InterruptedException {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
        synchronized (unread) {
            while (true) {
                while (!unread.isEmpty()) {
                    Event next = unread.removeFirst();
                    if (next.name().equals(event) && wanted.test(next)) {
                        return next;
                    }
                }
                long left = deadline - System.nanoTime();
                if (left <= 0 || ended) {
                    throw new DemoFailure((name + ": expected " + event + " " + description).strip()
                            + (ended ? ", but the program has ended" : " within " + seconds + " s"));
                }
                TimeUnit.NANOSECONDS.timedWait(unread, left);
            }
        }
    }

    /** Waits until the program has ended, with status 0. */
    void awaitEnd(int seconds) throws DemoFailure, InterruptedException {
        if (!process.waitFor(seconds, TimeUnit.SECONDS)) {
            throw new DemoFailure(name + ": expected to end within " + seconds + " s");
        }
        if (process.exitValue() != 0) {
            throw new DemoFailure(name + ": expected to end with status 0, found " + process.exitValue());
        }
    }

    private static boolean holds(Event event, String... fields) {
        for (String field : fields) {
            int equals = field.indexOf('=');
            if (!field.substring(equals + 1).equals(event.fields().get(field.substring(0, equals)))) {
                return false;
            }
        }
        return true;
    }

    private void read() {
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                transcript.line(name, line);
                add(line);
            }
        } catch (IOException e) {
            transcript.line(name, "its output broke off: " + e.getMessage());
        }
        synchronized (unread) {
            ended = true;
            unread.notifyAll();
        }
    }

    private void add(String line) {
        try {
            Event event = parse(line);
            synchronized (unread) {
                unread.addLast(event);
                unread.notifyAll();
            }
        } catch (CommandException e) {
            transcript.line(name, "that line is no event: " + e.getMessage());
        }
    }

    private static Event parse(String line) throws CommandException {
        ConsoleCommand words = ConsoleCommand.parse(line);
        Map<String, String> fields = new LinkedHashMap<>();
        for (String word : words.words()) {
            int equals = word.indexOf('=');
            if (equals > 0) {
                fields.put(word.substring(0, equals), word.substring(equals + 1));
            }
        }
        return new Event(words.name(), fields);
    }
}
