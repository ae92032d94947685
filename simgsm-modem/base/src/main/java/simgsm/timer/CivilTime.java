package simgsm.timer;

import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneId;

/**
 * Civil time. Timers use a monotonic clock; civil time follows the wall clock, which may be set and advances while
 * the machine sleeps.
 */
public final class CivilTime {
    /** Minimum difference of the clocks that renews timers. */
    private static final Duration JUMP = Duration.ofSeconds(1);

    private final Timers timers;
    /** Civil time at timer time 0. */
    private Instant zero;
    /** {@link #zero} at the last reported jump. */
    private Instant reportedZero;

    /** @param zero civil time at time 0 of {@code timers} */
    public CivilTime(Instant zero, Timers timers) {
        this.zero = zero;
        this.reportedZero = zero;
        this.timers = timers;
    }

    public Instant now() {
        return at(timers.nowNanos());
    }

    /** The civil time at a time of the timers, by the current difference of the clocks. */
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

    /** The present time in this machine's time zone. */
    public OffsetDateTime local() {
        return now().atZone(ZoneId.systemDefault()).toOffsetDateTime();
    }
}
