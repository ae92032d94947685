package simgsm.center.smpp;

import simgsm.timer.RateLimit;
import simgsm.timer.Timers;

/** How much an application on another machine may hand in; one on this machine is stopped by the queue's limit alone. */
final class Throttle {
    static final int MAX_UNANSWERED = 1_000;
    static final int PER_SECOND = 5_000;

    private final Timers timers;
    private final boolean isLocal;
    /** A second's worth may come at once. */
    private final RateLimit submissions = new RateLimit(PER_SECOND, PER_SECOND);

    private int unanswered;

    Throttle(Timers timers, boolean isLocal) {
        this.timers = timers;
        this.isLocal = isLocal;
    }

    /** @return false if the application has to wait */
    boolean admits() {
        return isLocal || unanswered < MAX_UNANSWERED && submissions.take(timers.nowNanos());
    }

    void begun() {
        unanswered++;
    }

    void answered() {
        unanswered--;
    }
}
