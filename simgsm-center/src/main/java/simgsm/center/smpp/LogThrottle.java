package simgsm.center.smpp;

import java.time.Duration;

/** Counts events that any peer can cause, so that the first is logged at once and the others at most once a minute. */
final class LogThrottle {
    static final long PERIOD_NANOS = Duration.ofMinutes(1).toNanos();

    private int unlogged;
    private long nextNanos = Long.MIN_VALUE;

    /** Counts further events; returns the number to log now, 0 if the last log line is less than a minute old. */
    int count(int more, long nowNanos) {
        unlogged += more;
        if (nowNanos < nextNanos) {
            return 0;
        }
        nextNanos = nowNanos + PERIOD_NANOS;
        int logged = unlogged;
        unlogged = 0;
        return logged;
    }
}
