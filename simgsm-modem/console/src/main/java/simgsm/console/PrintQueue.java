package simgsm.console;

import java.io.PrintStream;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/**
 * Prints events on a thread of its own, in order, so that a reader who is slow, or has stopped reading, never holds up the
 * thread of a protocol or of a simulation.
 */
final class PrintQueue implements AutoCloseable {
    /** Beyond this a reader who has stopped reading loses events. The longest list of any program is shorter. */
    static final int MAX_UNPRINTED = 1_000_000;

    /** So many lines go out with one write at most. */
    private static final int MAX_TOGETHER = 1_000;

    /** How long the last lines may take at the program's end. */
    private static final long DRAIN_MILLIS = 2_000;

    private static final Event END = Event.of("end");
    private static final System.Logger LOG = System.getLogger(PrintQueue.class.getName());

    private final PrintStream out;
    private final BlockingQueue<Event> queue = new LinkedBlockingQueue<>(MAX_UNPRINTED);
    private final Thread thread = new Thread(this::run, "console output");

    PrintQueue(PrintStream out) {
        this.out = out;
        thread.setDaemon(true);
        thread.start();
    }

    void print(Event event) {
        if (!queue.offer(event)) {
            LOG.log(Level.DEBUG, "nobody reads our output; lost: {0}", event);
        }
    }

    private void run() {
        List<Event> batch = new ArrayList<>();
        StringBuilder lines = new StringBuilder();
        try {
            while (true) {
                batch.add(queue.take());
                queue.drainTo(batch, MAX_TOGETHER);
                for (Event event : batch) {
                    if (event == END) {
                        print(lines);
                        return;
                    }
                    lines.append(event).append('\n');
                }
                print(lines);
                batch.clear();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** With one write, because thousands of events may come in a second. */
    private void print(StringBuilder lines) {
        out.print(lines);
        out.flush();
        lines.setLength(0);
    }

    /** Prints what is left, for a while. */
    @Override
    public void close() {
        queue.offer(END);
        try {
            thread.join(DRAIN_MILLIS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
