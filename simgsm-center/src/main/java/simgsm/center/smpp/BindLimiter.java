package simgsm.center.smpp;

import java.lang.System.Logger.Level;
import java.time.Duration;
import simgsm.timer.BoundedMap;

/**
 * Slows the guessing of passwords. Each address has {@link #FREE_REFUSALS} refused binds at once, then one bind a
 * second, right or wrong; with {@link #MAX_WAIT} waiting, further ones are refused without a check of the password.
 */
final class BindLimiter {
    static final int FREE_REFUSALS = 10;
    static final Duration MAX_WAIT = Duration.ofSeconds(10);
    /** The result of {@link #waitNanos} for a bind that is refused at once. */
    static final long REFUSED = -1;

    private static final System.Logger LOG = System.getLogger(BindLimiter.class.getName());
    private static final long EACH_NANOS = Duration.ofSeconds(1).toNanos();
    private static final int MAX_ADDRESSES = 10_000;

    /** End of the refused binds of an address if each took a second. */
    private final BoundedMap<String, Long> paidUntilNanos = new BoundedMap<>(MAX_ADDRESSES);

    private final LogThrottle log = new LogThrottle();

    /** Wait of a bind from this address before the check of its password; {@link #REFUSED} if it is refused at once. */
    long waitNanos(String address, long nowNanos) {
        long paid = paidUntilNanos.getOrDefault(address, nowNanos);
        long waitNanos = Math.max(0, paid - nowNanos - (FREE_REFUSALS - 1) * EACH_NANOS);
        if (waitNanos > MAX_WAIT.toNanos()) {
            return REFUSED;
        }
        if (waitNanos > 0) {
            pay(address, nowNanos);
        }
        return waitNanos;
    }

    /**
     * Counts a refused bind.
     *
     * @param hasWaited true if it has already waited
     */
    void refused(String address, String systemId, int status, boolean hasWaited, long nowNanos) {
        if (!hasWaited) {
            pay(address, nowNanos);
        }
        int count = log.count(1, nowNanos);
        if (count > 0) {
            LOG.log(
                    Level.WARNING,
                    "{0} binds refused, the last as \"{1}\" from {2}, status {3}",
                    count,
                    systemId,
                    address,
                    status);
        }
    }

    private void pay(String address, long nowNanos) {
        long paid = paidUntilNanos.getOrDefault(address, nowNanos);
        paidUntilNanos.putNewest(address, Math.max(nowNanos, paid) + EACH_NANOS);
    }
}
