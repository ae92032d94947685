package simgsm.center.msc.link;

import simgsm.timer.RateLimit;
import simgsm.timer.Timers;

/** Limits the requests of a terminal on another machine: above the rate of a person or robot, below that of a flood. */
public final class TerminalRateLimits {
    public static final int REGISTRATIONS_AT_ONCE = 10;
    public static final int CALLS_AT_ONCE = 20;
    /** One text of 255 parts and some further messages. */
    public static final int MESSAGES_AT_ONCE = 300;

    private static final int REGISTRATIONS_PER_SECOND = 1;
    private static final int CALLS_PER_SECOND = 2;
    private static final int MESSAGES_PER_SECOND = 10;

    private final boolean isLocal;
    private final Timers timers;
    private final RateLimit registrations = new RateLimit(REGISTRATIONS_PER_SECOND, REGISTRATIONS_AT_ONCE);
    private final RateLimit calls = new RateLimit(CALLS_PER_SECOND, CALLS_AT_ONCE);
    private final RateLimit messages = new RateLimit(MESSAGES_PER_SECOND, MESSAGES_AT_ONCE);

    TerminalRateLimits(boolean isLocal, Timers timers) {
        this.isLocal = isLocal;
        this.timers = timers;
    }

    public boolean admitRegistration() {
        return admit(registrations);
    }

    public boolean admitCall() {
        return admit(calls);
    }

    public boolean admitMessage() {
        return admit(messages);
    }

    private boolean admit(RateLimit limit) {
        return isLocal || limit.take(timers.nowNanos());
    }
}
