package simgsm.console;

import java.util.ArrayDeque;
import java.util.concurrent.TimeUnit;

/** The events after a console's cursor. Any thread may add; one thread waits. */
final class EventBuffer {
    /** Most unread events; older ones are dropped, for consoles without {@code wait}. */
    static final int MAX_UNREAD = 100_000;

    private final ArrayDeque<Event> unread = new ArrayDeque<>();
    private final long maxOctets;
    private long octets;

    EventBuffer() {
        this(Event.MAX_OCTETS_HELD);
    }

    /** @param maxOctets of memory; beyond them the oldest events are dropped, too, except the newest one */
    EventBuffer(long maxOctets) {
        this.maxOctets = maxOctets;
    }

    synchronized void add(Event event) {
        octets += event.octetsHeld();
        while (unread.size() == MAX_UNREAD || octets > maxOctets && !unread.isEmpty()) {
            removeFirst();
        }
        unread.addLast(event);
        notifyAll();
    }

    private Event removeFirst() {
        Event first = unread.removeFirst();
        octets -= first.octetsHeld();
        return first;
    }

    /** Sets the cursor to the end. */
    synchronized void skip() {
        unread.clear();
        octets = 0;
    }

    /**
     * Waits for an event after the cursor with this name and at least these fields, and sets the cursor after it; at
     * the time-out, to the end.
     *
     * @return true if the event was found
     */
    synchronized boolean await(Event wanted, long timeoutNanos) throws InterruptedException {
        long end = System.nanoTime() + timeoutNanos;
        while (true) {
            while (!unread.isEmpty()) {
                if (removeFirst().matches(wanted)) {
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
