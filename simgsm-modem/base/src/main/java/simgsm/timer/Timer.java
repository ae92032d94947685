package simgsm.timer;

/** One running timer of {@link Timers}. */
public final class Timer {
    final long deadlineNanos;
    final long order;
    final Runnable action;
    /** Position in the heap; {@link TimerHeap#GONE} once expired or cancelled. */
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
        return position != TimerHeap.GONE;
    }

    boolean isBefore(Timer other) {
        return deadlineNanos < other.deadlineNanos || deadlineNanos == other.deadlineNanos && order < other.order;
    }
}
