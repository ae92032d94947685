package simgsm.station.mobility;

import java.util.random.RandomGenerator;
import simgsm.station.context.StationTimer;
import simgsm.station.context.StationTimers;

/** T3212, after which the location is updated even in the same area (TS 24.008, 4.4.2). */
final class PeriodicUpdating {
    private final StationTimers timers;
    private final RandomGenerator random;
    private long periodNanos;
    private boolean isDue;

    PeriodicUpdating(StationTimers timers, RandomGenerator random) {
        this.timers = timers;
        this.random = random;
    }

    /**
     * The cell has sent its value. A running timer keeps its remaining time, modulo the new value; a mobile
     * registered without periodic updating draws the time of its first update.
     *
     * @param steps of 6 minutes; 0 for no periodic updating
     */
    void told(int steps, boolean isRegistered) {
        long told = steps * StationTimer.T3212.nanos();
        if (told == periodNanos) {
            return;
        }
        periodNanos = told;
        if (told == 0) {
            stop();
        } else if (timers.isRunning(StationTimer.T3212)) {
            start(timers.remainingNanos(StationTimer.T3212) % told);
        } else if (isRegistered && !isDue) {
            start(random.nextLong(told));
        }
    }

    /** T3212 of the cell; one step if it gives none. */
    long nanos() {
        return Math.max(periodNanos, StationTimer.T3212.nanos());
    }

    private void start(long nanos) {
        timers.start(StationTimer.T3212, nanos, () -> isDue = true);
    }

    /**
     * The network has answered on a connection: the period restarts with idle mode. An update that is due remains
     * due.
     */
    void contacted() {
        timers.stop(StationTimer.T3212);
    }

    void stop() {
        timers.stop(StationTimer.T3212);
        isDue = false;
    }

    /** The mobile is registered and has no radio connection. */
    void idle() {
        if (periodNanos > 0 && !isDue && !timers.isRunning(StationTimer.T3212)) {
            start(periodNanos);
        }
    }

    boolean isDue() {
        return isDue;
    }
}
