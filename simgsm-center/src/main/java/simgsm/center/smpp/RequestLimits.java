package simgsm.center.smpp;

import simgsm.timer.RateLimit;
import simgsm.timer.Timers;

/**
 * Limits of an application's requests. A local application is limited only by the queues, unless its settings have a
 * rate.
 */
final class RequestLimits {
    static final int MAX_UNANSWERED = 1_000;
    /** Maximum rate and burst. */
    static final int PER_SECOND = 5_000;

    private final Timers timers;
    private final boolean isLocal;
    /** Null without a limit. */
    private RateLimit rate;

    private int unanswered;

    RequestLimits(Timers timers, boolean isLocal) {
        this.timers = timers;
        this.isLocal = isLocal;
        rate = isLocal ? null : new RateLimit(PER_SECOND, PER_SECOND);
    }

    /** Replaces the limit, with a burst of one second's requests. */
    void setRate(int perSecond) {
        rate = new RateLimit(perSecond, perSecond);
    }

    /** Counts a request against the rate; false if it has to be refused. */
    boolean admit() {
        boolean hasRoom = isLocal || unanswered < MAX_UNANSWERED;
        return hasRoom && (rate == null || rate.take(timers.nowNanos()));
    }

    void begun() {
        unanswered++;
    }

    void answered() {
        unanswered--;
    }
}
