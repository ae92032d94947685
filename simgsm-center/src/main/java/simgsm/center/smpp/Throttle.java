package simgsm.center.smpp;

import java.time.Duration;
import simgsm.center.timer.Timers;

/** How much an application on another machine may hand in; one on this machine is stopped by the queue's limit alone. */
final class Throttle {
    static final int MAX_UNANSWERED = 1_000;
    static final int PER_SECOND = 5_000;

    private static final long NANOS_EACH = Duration.ofSeconds(1).toNanos() / PER_SECOND;
    /** A second's worth may come at once. */
    private static final long BURST_NANOS = Duration.ofSeconds(1).toNanos();

    private final Timers timers;
    private final boolean isLocal;
    private int unanswered;
    /** When all that came so far would have come at the even pace. */
    private long paidUntilNanos;

    Throttle(Timers timers, boolean isLocal) {
        this.timers = timers;
        this.isLocal = isLocal;
    }

    /** @return false if the application has to wait */
    boolean admits() {
        if (isLocal) {
            return true;
        }
        long now = timers.nowNanos();
        long paid = Math.max(now, paidUntilNanos) + NANOS_EACH;
        if (unanswered >= MAX_UNANSWERED || paid > now + BURST_NANOS) {
            return false;
        }
        paidUntilNanos = paid;
        return true;
    }

    void begun() {
        unanswered++;
    }

    void answered() {
        unanswered--;
    }
}
