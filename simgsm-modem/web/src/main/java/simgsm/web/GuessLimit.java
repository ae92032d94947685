package simgsm.web;

import java.net.InetAddress;
import java.util.Map;
import simgsm.timer.BoundedMap;
import simgsm.timer.RateLimit;

/**
 * Slows the guessing of keys: each address may send 10 wrong ones at once, then one a second. Its further keys, right
 * or wrong, are refused unread until then, so that a guess is not told from a right key.
 */
final class GuessLimit {
    /** At once, after 10 s without a wrong key. */
    static final int MOST_AT_ONCE = 10;

    private final Map<InetAddress, RateLimit> addresses = new BoundedMap<>();

    /** @throws RequestException with status 429 if an address has sent too many wrong keys */
    void require(InetAddress from, long nowNanos) throws RequestException {
        RateLimit wrong = addresses.get(from);
        if (wrong != null && !wrong.isLeft(nowNanos)) {
            throw new RequestException(
                    WebResponse.TOO_MANY_REQUESTS,
                    "too many wrong keys from this address, expected at most one a second; try again in a second");
        }
    }

    /** Counts a wrong key. */
    void countWrong(InetAddress from, long nowNanos) {
        addresses
                .computeIfAbsent(from, unknown -> new RateLimit(1, MOST_AT_ONCE))
                .take(nowNanos);
    }
}
