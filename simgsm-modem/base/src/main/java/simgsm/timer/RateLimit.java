package simgsm.timer;

import java.time.Duration;

/** Limits a rate: a number of acts per second in the long run, and a larger number at once after a pause. */
public final class RateLimit {
    private static final long SECOND_NANOS = Duration.ofSeconds(1).toNanos();

    private final long nanosEach;
    private final long burstNanos;
    /** End of the acts so far if evenly spaced. */
    private long paidUntilNanos = Long.MIN_VALUE;

    /** @param burst acts at once after a pause, at least 1 */
    public RateLimit(int perSecond, int burst) {
        if (perSecond < 1 || burst < 1) {
            throw new IllegalArgumentException(
                    "expected an allowance of at least 1, found " + perSecond + " a second, " + burst + " at once");
        }
        nanosEach = SECOND_NANOS / perSecond;
        burstNanos = burst * nanosEach;
    }

    /** Counts one act; false if it is not allowed now. */
    public boolean take(long nowNanos) {
        if (!isLeft(nowNanos)) {
            return false;
        }
        paidUntilNanos = Math.max(nowNanos, paidUntilNanos) + nanosEach;
        return true;
    }

    public boolean isLeft(long nowNanos) {
        return Math.max(nowNanos, paidUntilNanos) + nanosEach <= nowNanos + burstNanos;
    }
}
