package simgsm.station;

import java.util.Arrays;
import java.util.Optional;

/** A station's time, as it was last told, and what it waits for. */
final class StationTimers {
    private static final StationTimer[] TIMERS = StationTimer.values();

    private final long[] deadlines = new long[TIMERS.length];
    private long nowNanos;
    /** The earliest of the deadlines. */
    private long nextNanos = MobileStation.NO_DEADLINE;

    StationTimers() {
        Arrays.fill(deadlines, MobileStation.NO_DEADLINE);
    }

    long nowNanos() {
        return nowNanos;
    }

    void advanceTo(long nanos) {
        nowNanos = nanos;
    }

    void start(StationTimer timer) {
        start(timer, timer.nanos());
    }

    void start(StationTimer timer, long nanos) {
        startAt(timer, nowNanos + nanos);
    }

    void startAt(StationTimer timer, long deadlineNanos) {
        deadlines[timer.ordinal()] = deadlineNanos;
        nextNanos = Arrays.stream(deadlines).min().orElseThrow();
    }

    void stop(StationTimer timer) {
        if (isRunning(timer)) {
            startAt(timer, MobileStation.NO_DEADLINE);
        }
    }

    boolean isRunning(StationTimer timer) {
        return deadlines[timer.ordinal()] != MobileStation.NO_DEADLINE;
    }

    long nextDeadlineNanos() {
        return nextNanos;
    }

    /** Takes the timer that has been due the longest, if one is due. */
    Optional<StationTimer> expired() {
        if (nextNanos > nowNanos) {
            return Optional.empty();
        }
        for (StationTimer timer : TIMERS) {
            if (deadlines[timer.ordinal()] == nextNanos) {
                stop(timer);
                return Optional.of(timer);
            }
        }
        return Optional.empty();
    }
}
