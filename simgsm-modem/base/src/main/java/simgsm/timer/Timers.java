package simgsm.timer;

import java.util.OptionalLong;
import java.util.function.Consumer;

/**
 * Running timers, and the only clock of a core: the driver moves it with {@link #advance}. Start, cancel and expiry
 * cost O(log n). Timers with equal deadlines expire in the order of their start.
 */
public final class Timers {
    private final TimerHeap heap;
    /** Null if exceptions propagate to the caller of {@link #advance}. */
    private final Consumer<RuntimeException> failed;

    /** At time 0, without running timers. */
    public Timers() {
        this(new TimerHeap(), null);
    }

    private Timers(TimerHeap heap, Consumer<RuntimeException> failed) {
        this.heap = heap;
        this.failed = failed;
    }

    /**
     * The same clock and timers for one owner, such as a connection: an exception in an action started here is passed
     * to the owner's handler, not to the caller of {@link #advance}, which may act for another owner.
     */
    public Timers ownedBy(Consumer<RuntimeException> handler) {
        return new Timers(heap, handler);
    }

    /** Nanoseconds since the start, as last advanced. */
    public long nowNanos() {
        return heap.nowNanos();
    }

    /** Sets an action that runs after each start of a timer that expires first. */
    public void onEarlier(Runnable action) {
        heap.onEarlier(action);
    }

    /** Number of running timers. */
    public int size() {
        return heap.size();
    }

    /** The earliest deadline; empty when no timer runs. */
    public OptionalLong nextDeadlineNanos() {
        return heap.nextDeadlineNanos();
    }

    public Timer start(long delayNanos, Runnable action) {
        return heap.start(delayNanos, failed == null ? action : () -> runOwned(action));
    }

    private void runOwned(Runnable action) {
        try {
            action.run();
        } catch (RuntimeException e) {
            failed.accept(e);
        }
    }

    /** Stops a timer; null and timers that have ended are ignored. */
    public void cancel(Timer timer) {
        heap.cancel(timer);
    }

    /**
     * Moves the time forward and runs the actions that fall due, each at its own deadline. Time never decreases: an earlier
     * time counts as the current one.
     */
    public void advance(long toNanos) {
        heap.advance(toNanos);
    }
}
