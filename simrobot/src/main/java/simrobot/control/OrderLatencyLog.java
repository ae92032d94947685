package simrobot.control;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.function.LongSupplier;
import vericommand.Verdict;

/**
 * Writes one log line per order and measures its latency: from the start of the order's last key in the received audio
 * to the wheels' first motion.
 */
final class OrderLatencyLog {
    private static final Logger LOG = System.getLogger(OrderLatencyLog.class.getName());
    private static final long UNKNOWN = Long.MIN_VALUE;

    private final String robot;
    private final LongSupplier clockNanos;
    private long keyBeganNanos = UNKNOWN;
    private String waiting = "";
    private long waitingSinceNanos;

    OrderLatencyLog(String robot, LongSupplier clockNanos) {
        this.robot = robot;
        this.clockNanos = clockNanos;
    }

    /** A key was received by tone; the latency of the order that it completes is measured from {@code nanos}. */
    void keyBegan(long nanos) {
        keyBeganNanos = nanos;
    }

    /** Clears the key's time, after a key or before a short message, which has no key. */
    void noKey() {
        keyBeganNanos = UNKNOWN;
    }

    void order(Verdict verdict) {
        String line = "order " + text(verdict) + " " + verdict.word();
        if (verdict instanceof Verdict.Accepted accepted && accepted.order().moves() && keyBeganNanos != UNKNOWN) {
            waiting = line;
            waitingSinceNanos = keyBeganNanos;
        } else {
            log(line);
        }
    }

    /** @return milliseconds since the order's last key began, or -1 if no order waits for motion */
    long wheelsMoved() {
        if (waiting.isEmpty()) {
            return -1;
        }
        long millis = Math.round((clockNanos.getAsLong() - waitingSinceNanos) / 1e6);
        log(waiting + "; wheels moved " + millis + " ms after the last key began");
        waiting = "";
        return millis;
    }

    /** Logs an order that ended before the wheels moved. */
    void orderEnded() {
        if (!waiting.isEmpty()) {
            log(waiting + "; the wheels did not move");
            waiting = "";
        }
    }

    private void log(String line) {
        LOG.log(Level.INFO, robot + ": " + line);
    }

    private static String text(Verdict verdict) {
        if (verdict instanceof Verdict.Accepted accepted) {
            return accepted.order().text();
        }
        return verdict instanceof Verdict.Refused refused ? refused.order().text() : verdict.keys();
    }
}
