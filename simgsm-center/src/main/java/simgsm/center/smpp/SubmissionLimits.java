package simgsm.center.smpp;

import simgsm.timer.RateLimit;
import simgsm.timer.Timers;

/** Limits of an application's submissions; an application on this machine has none but those of the queues. */
final class SubmissionLimits {
    static final int MAX_UNANSWERED = 1_000;
    /** Also the largest burst. */
    static final int PER_SECOND = 5_000;

    private final Timers timers;
    private final boolean isLocal;
    private final RateLimit rate = new RateLimit(PER_SECOND, PER_SECOND);

    private int unanswered;

    SubmissionLimits(Timers timers, boolean isLocal) {
        this.timers = timers;
        this.isLocal = isLocal;
    }

    /** Counts a submission against the rate; false if it has to be refused. */
    boolean admit() {
        return isLocal || unanswered < MAX_UNANSWERED && rate.take(timers.nowNanos());
    }

    void begun() {
        unanswered++;
    }

    void answered() {
        unanswered--;
    }
}
