package simgsm.timer;

/** One deadline in a {@link Timers}; owned by whoever started it. */
public final class Timer {
    final long deadlineNanos;
    final long order;
    final Runnable action;
    /** Position in the heap; {@link Timers#GONE} once expired or cancelled. */
    int position;

    Timer(long deadlineNanos, long order, Runnable action) {
        this.deadlineNanos = deadlineNanos;
        this.order = order;
        this.action = action;
    }

    public long deadlineNanos() {
        return deadlineNanos;
    }

    public boolean isRunning() {
        return position != Timers.GONE;
    }

    boolean isBefore(Timer other) {
        return deadlineNanos < other.deadlineNanos || deadlineNanos == other.deadlineNanos && order < other.order;
    }
}
