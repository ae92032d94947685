package simgsm.center.net;

import java.util.function.Consumer;
import simgsm.center.msc.Exchange;

/** Somebody who looks at the exchange: after changes, not too often, but always once more after the last change. */
final class View {
    private Consumer<Exchange> look = exchange -> {};
    private long periodNanos;
    private long earliestNanos;
    private boolean isWatched;
    private boolean isStale = true;

    void watch(long period, Consumer<Exchange> watcher) {
        periodNanos = period;
        look = watcher;
        isWatched = true;
    }

    void changed() {
        isStale = true;
    }

    /** When to look next; never, if nobody watches or nothing has changed. */
    long dueNanos() {
        return isWatched && isStale ? earliestNanos : Long.MAX_VALUE;
    }

    void lookIfDue(long nowNanos, Exchange exchange) {
        if (nowNanos >= dueNanos()) {
            isStale = false;
            earliestNanos = nowNanos + periodNanos;
            look.accept(exchange);
        }
    }
}
