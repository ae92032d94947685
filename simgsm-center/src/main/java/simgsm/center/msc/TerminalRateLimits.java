package simgsm.center.msc;

import simgsm.timer.RateLimit;
import simgsm.timer.Timers;

/**
 * How often a terminal of another machine may ask for something: more than any person or robot does, less than a flood. A
 * terminal of this machine is not held to it.
 */
final class TerminalRateLimits {
    static final int REGISTRATIONS_PER_SECOND = 1;
    static final int REGISTRATIONS_AT_ONCE = 10;
    static final int CALLS_PER_SECOND = 2;
    static final int CALLS_AT_ONCE = 20;
    static final int MESSAGES_PER_SECOND = 10;
    /** A text of 255 parts, and some. */
    static final int MESSAGES_AT_ONCE = 300;

    private final boolean isLocal;
    private final Timers timers;
    private final RateLimit registrations = new RateLimit(REGISTRATIONS_PER_SECOND, REGISTRATIONS_AT_ONCE);
    private final RateLimit calls = new RateLimit(CALLS_PER_SECOND, CALLS_AT_ONCE);
    private final RateLimit messages = new RateLimit(MESSAGES_PER_SECOND, MESSAGES_AT_ONCE);

    TerminalRateLimits(boolean isLocal, Timers timers) {
        this.isLocal = isLocal;
        this.timers = timers;
    }

    boolean admitsRegistration() {
        return admits(registrations);
    }

    boolean admitsCall() {
        return admits(calls);
    }

    boolean admitsMessage() {
        return admits(messages);
    }

    private boolean admits(RateLimit allowance) {
        return isLocal || allowance.take(timers.nowNanos());
    }
}
