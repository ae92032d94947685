package simgsm.console;

import java.util.ArrayDeque;
import java.util.concurrent.TimeUnit;

/** The events after a console's cursor. Any thread may add; one thread waits. */
final class EventBuffer {
    /** Most unread events; beyond it the oldest are dropped, for consoles without {@code wait}. */
    static final int MAX_UNREAD = 100_000;

    private final ArrayDeque<Event> unread = new ArrayDeque<>();

    synchronized void add(Event event) {
        if (unread.size() == MAX_UNREAD) {
            unread.removeFirst();
        }
        unread.addLast(event);
        notifyAll();
    }

    /** Sets the cursor to the end. */
    synchronized void skip() {
        unread.clear();
    }

    /**
     * Waits for an event after the cursor with this name and at least these fields, and sets the cursor after it; at the
     * time-out, to the end.
     *
     * @return whether the event came
     */
    synchronized boolean await(Event wanted, long timeoutNanos) throws InterruptedException {
        long end = System.nanoTime() + timeoutNanos;
        while (true) {
            while (!unread.isEmpty()) {
                if (unread.removeFirst().matches(wanted)) {
                    return true;
                }
            }
            long left = end - System.nanoTime();
            if (left <= 0) {
                return false;
            }
            TimeUnit.NANOSECONDS.timedWait(this, Math.max(left, 1_000_000));
        }
    }
}
