package simgsm.timer;

import java.time.Duration;
import java.time.Instant;

/**
 * Civil time. Timers follow a monotonic clock; civil time follows the wall clock, which may be set
 * and advances while the machine sleeps.
 */
public final class CivilTime {
    /** A smaller difference of the clocks needs no new timers. */
    private static final Duration JUMP = Duration.ofSeconds(1);

    private final Timers timers;
    /** The civil time at which the timers stood at 0. */
    private Instant zero;
    /** The same when the last jump was reported. */
    private Instant reportedZero;

    /** @param zero the civil time at which {@code timers} stood at 0 */
    public CivilTime(Instant zero, Timers timers) {
        this.zero = zero;
        this.reportedZero = zero;
        this.timers = timers;
    }

    public Instant now() {
        return at(timers.nowNanos());
    }

    /** The civil time at a time of the timers, as far as is known now. */
    public Instant at(long nanos) {
        return zero.plusNanos(nanos);
    }

    /** The wall clock shows this now. @return true if times have jumped by 1 s or more since the last jump */
    public boolean isJump(Instant wall) {
        zero = wall.minusNanos(timers.nowNanos());
        boolean hasJumped = Duration.between(reportedZero, zero).abs().compareTo(JUMP) >= 0;
        if (hasJumped) {
            reportedZero = zero;
        }
        return hasJumped;
    }
}
