package simgsm.classroom.demo;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Predicate;
import simgsm.center.app.ChildConsole;
import simgsm.console.Event;

/** The console of one program of the demo: commands go in, events come out and into the transcript. */
final class DemoConsole implements ChildConsole.Listener {
    private final String name;
    private final Process process;
    private final ChildConsole console;
    private final DemoTranscript transcript;
    private final Consumer<Event> listener;
    private final ArrayDeque<Event> unread = new ArrayDeque<>();
    private boolean ended;

    DemoConsole(String name, Process process, DemoTranscript transcript) {
        this(name, process, transcript, event -> {});
    }

    /** @param listener receives each event, too, on the console's thread */
    DemoConsole(String name, Process process, DemoTranscript transcript, Consumer<Event> listener) {
        this.listener = listener;
        this.name = name;
        this.process = process;
        this.transcript = transcript;
        this.console = new ChildConsole(name, process, this);
    }

    /** Enters a command and adds it to the transcript. */
    void command(String line) throws DemoFailure {
        transcript.line(name, "> " + line);
        try {
            console.command(line);
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

    @Override
    public void line(String line) {
        transcript.line(name, line);
    }

    @Override
    public void event(Event event) {
        listener.accept(event);
        synchronized (unread) {
            unread.addLast(event);
            unread.notifyAll();
        }
    }

    @Override
    public void ended() {
        synchronized (unread) {
            ended = true;
            unread.notifyAll();
        }
    }
}
