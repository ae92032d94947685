package simgsm.center.smpp;

import simgsm.timer.RateLimit;
import simgsm.timer.Timers;

/**
 * Limits of an application's requests. An application on this machine has none but those of the queues, unless its settings
 * have a rate.
 */
final class RequestLimits {
    static final int MAX_UNANSWERED = 1_000;
    /** Also the largest burst. */
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

    /** Replaces the limit by another one, with as many requests at once as in a second. */
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
