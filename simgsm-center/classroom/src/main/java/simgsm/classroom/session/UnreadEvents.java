package simgsm.classroom.session;

import java.util.ArrayDeque;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/** Events that no wait has consumed or skipped, at most 10 000. Any thread may add; one thread waits. */
public final class UnreadEvents<E> {
    private static final int MOST_UNREAD = 10_000;

    private final ArrayDeque<E> unread = new ArrayDeque<>();
    private boolean isEnded;

    public synchronized void add(E event) {
        unread.addLast(event);
        if (unread.size() > MOST_UNREAD) {
            unread.removeFirst();
        }
        notifyAll();
    }

    /** Ends all waits, because the source has ended. */
    public synchronized void end() {
        isEnded = true;
        notifyAll();
    }

    public synchronized boolean isEnded() {
        return isEnded;
    }

    public synchronized void clear() {
        unread.clear();
    }

    /**
     * Waits for the next wanted event and removes it with its predecessors; empty if the time or the source ends first.
     */
    public synchronized Optional<E> await(Predicate<E> wanted, double seconds) throws InterruptedException {
        long deadline = System.nanoTime() + (long) (seconds * TimeUnit.SECONDS.toNanos(1));
        while (true) {
            while (!unread.isEmpty()) {
                E next = unread.removeFirst();
                if (wanted.test(next)) {
                    return Optional.of(next);
                }
            }
            long left = deadline - System.nanoTime();
            if (left <= 0 || isEnded) {
                return Optional.empty();
            }
            TimeUnit.NANOSECONDS.timedWait(this, left);
        }
    }
}
