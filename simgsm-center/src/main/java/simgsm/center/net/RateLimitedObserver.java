package simgsm.center.net;

import java.util.function.Consumer;
import simgsm.center.msc.Exchange;

/** Shows the exchange to an observer after changes, at most once per period, and once more after the last change. */
final class RateLimitedObserver {
    private Consumer<Exchange> observer = exchange -> {};
    private long periodNanos;
    private long earliestNanos;
    private boolean isSet;
    private boolean isStale = true;

    void set(long newPeriodNanos, Consumer<Exchange> newObserver) {
        periodNanos = newPeriodNanos;
        observer = newObserver;
        isSet = true;
    }

    void changed() {
        isStale = true;
    }

    /** Time of the next {@link #showIfDue}; never without an observer or without a change. */
    long dueNanos() {
        return isSet && isStale ? earliestNanos : Long.MAX_VALUE;
    }

    void showIfDue(long nowNanos, Exchange exchange) {
        if (nowNanos >= dueNanos()) {
            isStale = false;
            earliestNanos = nowNanos + periodNanos;
            observer.accept(exchange);
        }
    }
}
