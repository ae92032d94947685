package simgsm.console;

import java.io.PrintStream;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicLong;
import simgsm.thread.DaemonThread;

/**
 * Prints events in order on its own thread, so that a slow or stopped reader of standard output never blocks the thread
 * of a protocol or a simulation.
 */
final class EventOutputQueue implements AutoCloseable {
    /** Most waiting events; further ones are dropped. The longest list of any program is shorter. */
    static final int MAX_UNPRINTED = 1_000_000;

    /** Most lines per write. */
    private static final int MAX_TOGETHER = 1_000;

    /** Time-out for the last lines at the program's end. */
    private static final long DRAIN_MILLIS = 2_000;

    private static final Event END = Event.of("end");
    private static final System.Logger LOG = System.getLogger(EventOutputQueue.class.getName());

    private final PrintStream out;
    private final Runnable lost;
    private boolean isLost;
    private final BlockingQueue<Event> queue = new LinkedBlockingQueue<>(MAX_UNPRINTED);
    private final long maxOctets;
    private final AtomicLong octets = new AtomicLong();
    private final Thread thread = DaemonThread.of("console output", this::run);

    /** @param lost runs once, when the output cannot be written */
    EventOutputQueue(PrintStream out, Runnable lost) {
        this(out, lost, Event.MAX_OCTETS_HELD);
    }

    /** @param maxOctets memory of waiting events above which {@link #awaitRoom} waits */
    EventOutputQueue(PrintStream out, Runnable lost, long maxOctets) {
        this.out = out;
        this.lost = lost;
        this.maxOctets = maxOctets;
        thread.start();
    }

    void print(Event event) {
        octets.addAndGet(event.octetsHeld());
        if (!queue.offer(event)) {
            octets.addAndGet(-event.octetsHeld());
            LOG.log(Level.DEBUG, "standard output is not read; dropped: {0}", event);
        }
    }

    /**
     * Waits until the waiting events take little memory. Called by the thread that reads commands, so that unread
     * answers do not fill the heap.
     */
    synchronized void awaitRoom() throws InterruptedException {
        while (octets.get() > maxOctets) {
            wait();
        }
    }

    private synchronized void printed(List<Event> events) {
        events.forEach(event -> octets.addAndGet(-event.octetsHeld()));
        notifyAll();
    }

    private void run() throws InterruptedException {
        List<Event> batch = new ArrayList<>();
        StringBuilder lines = new StringBuilder();
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
            printed(batch);
            batch.clear();
        }
    }

    /** One write for all lines, because there may be thousands of events a second. */
    private void print(StringBuilder lines) {
        out.print(lines);
        lines.setLength(0);
        if (out.checkError() && !isLost) {
            isLost = true;
            lost.run();
        }
    }

    /** Prints the waiting events, for at most 2 s. */
    @Override
    public void close() {
        queue.offer(END);
        DaemonThread.join(thread, DRAIN_MILLIS);
    }
}
