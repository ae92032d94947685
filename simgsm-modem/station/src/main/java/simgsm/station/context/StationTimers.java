package simgsm.station.context;

import java.util.EnumMap;
import java.util.Map;
import java.util.OptionalLong;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * The timers of one station by name; one of each name runs at a time. A timer started late, because the owner was
 * delayed, counts from the owner's time and not from the missed deadline.
 */
public final class StationTimers {
    private final Timers timers = new Timers();
    private final Map<StationTimer, Timer> running = new EnumMap<>(StationTimer.class);
    private final Runnable settle;
    private long nowNanos;

    StationTimers(Runnable settle) {
        this.settle = settle;
    }

    /** The same clock, for parts with their own timers. */
    public Timers unnamed() {
        return timers;
    }

    /** The time of the last {@link #advanceTo}. */
    public long nowNanos() {
        return nowNanos;
    }

    /** Runs the actions of all timers that expire up to this time. */
    public void advanceTo(long nanos) {
        nowNanos = nanos;
        timers.advance(nanos);
    }

    public void start(StationTimer timer, Runnable expired) {
        start(timer, timer.nanos(), expired);
    }

    /** Starts a timer with its own duration; a running one of that name is stopped. */
    public void start(StationTimer timer, long nanos, Runnable expired) {
        stop(timer);
        running.put(timer, timers.start(nowNanos + nanos - timers.nowNanos(), () -> {
            expired.run();
            settle.run();
        }));
    }

    public void stop(StationTimer... all) {
        for (StationTimer timer : all) {
            timers.cancel(running.remove(timer));
        }
    }

    public boolean isRunning(StationTimer timer) {
        Timer started = running.get(timer);
        return started != null && started.isRunning();
    }

    /** Rest of a running timer. */
    public long remainingNanos(StationTimer timer) {
        return Math.max(0, running.get(timer).deadlineNanos() - nowNanos);
    }

    public OptionalLong nextDeadlineNanos() {
        return timers.nextDeadlineNanos();
    }
}
