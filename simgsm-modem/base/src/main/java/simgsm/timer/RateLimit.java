package simgsm.timer;

import java.time.Duration;

/**
 * How much of something somebody may do: so many a second in the long run, and a number of them at once after a rest.
 */
public final class RateLimit {
    private static final long SECOND_NANOS = Duration.ofSeconds(1).toNanos();

    private final long nanosEach;
    private final long burstNanos;
    /** When all that was done so far would have been done at the even pace. */
    private long paidUntilNanos;

    /** @param burst how many may be done at once, 1 at least */
    public RateLimit(int perSecond, int burst) {
        if (perSecond < 1 || burst < 1) {
            throw new IllegalArgumentException(
                    "expected an allowance of at least 1, found " + perSecond + " a second, " + burst + " at once");
        }
        nanosEach = SECOND_NANOS / perSecond;
        burstNanos = burst * nanosEach;
    }

    /** Does one more if that is allowed now. */
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
