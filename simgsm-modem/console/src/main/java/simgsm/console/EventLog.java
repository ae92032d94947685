package simgsm.console;

import java.util.ArrayDeque;
import java.util.concurrent.TimeUnit;

/** The events behind a console's cursor. Any thread may add; one thread waits. */
final class EventLog {
    /** Beyond this many unread events the oldest are forgotten, so that a console nobody waits on stays small. */
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
     * Looks from the cursor on for an event of this name with at least these fields and sets the cursor behind it; when the time is over, to the end.
     *
     * @return whether the event came
     */
    synchronized boolean await(Event wanted, long timeoutNanos) throws InterruptedException {
        long end = System.nanoTime() + timeoutNanos;
        while (true) {
            while (!unread.isEmpty()) {
                if (unread.removeFirst().answers(wanted)) {
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
