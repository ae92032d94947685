package simrobot.http;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import simgsm.timer.RateLimit;
import simgsm.web.RequestException;
import simgsm.web.WebResponse;

/**
 * Limits one operator to 10 requests a second, and performs requests with the same Idempotency-Key once in 24 h, one
 * after the other. Callable on any thread.
 */
final class OperatorRequests {
    static final int PER_SECOND = 10;
    /** Allows one per second for a day. */
    static final int MOST_KEYS = 100_000;

    static final long KEPT_NANOS = TimeUnit.HOURS.toNanos(24);

    /** Performs a request. A refusal that it throws is not stored. */
    interface Request {
        PlacedOrder perform() throws InterruptedException, RequestException;
    }

    /** @param request hash of the request's content */
    private record Performed(UUID request, PlacedOrder answer, long atNanos) {}

    private final RateLimit rate = new RateLimit(PER_SECOND, PER_SECOND);
    /** Performed requests by their Idempotency-Keys, oldest first. */
    private final Map<String, Performed> performed = new LinkedHashMap<>();

    /** @throws RequestException with status 429 for more than 10 requests a second */
    synchronized void requireRate(long nowNanos) throws RequestException {
        if (!rate.take(nowNanos)) {
            throw tooMany("more than " + PER_SECOND + " requests a second with this key");
        }
    }

    private static RequestException tooMany(String text) {
        return new RequestException(WebResponse.TOO_MANY_REQUESTS, text);
    }

    /**
     * The answer to a request, the same each time.
     *
     * @throws RequestException with status 422 if the key was used with another request within 24 h
     */
    synchronized PlacedOrder once(String key, UUID request, Request act, long nowNanos)
            throws InterruptedException, RequestException {
        forgetOld(nowNanos);
        Performed before = performed.get(key);
        if (before == null) {
            if (performed.size() == MOST_KEYS) {
                throw tooMany("more than " + MOST_KEYS + " Idempotency-Keys within 24 h");
            }
            before = new Performed(request, act.perform(), nowNanos);
            performed.put(key, before);
        } else if (!before.request().equals(request)) {
            throw new RequestException(
                    WebResponse.UNPROCESSABLE,
                    "the Idempotency-Key came with another order within 24 h, expected a new one");
        }
        return before.answer();
    }

    private void forgetOld(long nowNanos) {
        Iterator<Performed> oldestFirst = performed.values().iterator();
        while (oldestFirst.hasNext() && nowNanos - oldestFirst.next().atNanos() >= KEPT_NANOS) {
            oldestFirst.remove();
        }
    }
}
