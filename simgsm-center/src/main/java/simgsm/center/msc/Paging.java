package simgsm.center.msc;

import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import simgsm.abis.RslMessage;
import simgsm.air.MobileIdentity;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** Brings a mobile onto a radio connection when the network wants something from it (TS 44.018, 3.3.2). */
final class Paging {
    /** T3113: how long to wait before paging again; the network's choice. */
    private static final long T3113_NANOS = Duration.ofSeconds(3).toNanos();

    private static final int ATTEMPTS = 3;

    private final Link link;
    private final Timers timers;
    private final Set<PagedTransaction> waiting = new LinkedHashSet<>();
    private Timer repetition;
    private int attempts;

    Paging(Link link, Timers timers) {
        this.link = link;
        this.timers = timers;
    }

    /** Goes on at once where the mobile is on a connection already; else it is paged as soon as it can hear. */
    void request(PagedTransaction transaction) {
        waiting.add(transaction);
        if (link.radio.isEstablished() && link.registration == null) {
            answered();
        } else {
            resume();
        }
    }

    void cancel(PagedTransaction transaction) {
        waiting.remove(transaction);
        if (waiting.isEmpty()) {
            stop();
        }
    }

    /** Pages for those who still wait, if the mobile is idle and not being paged. */
    void resume() {
        if (!waiting.isEmpty() && link.radio.isIdle() && repetition == null) {
            attempts = 0;
            page();
        }
    }

    /** The mobile is on a connection; any first message counts as its answer. */
    void answered() {
        stop();
        List<PagedTransaction> ready = List.copyOf(waiting);
        waiting.clear();
        ready.forEach(PagedTransaction::radioConnected);
    }

    void fail() {
        stop();
        List<PagedTransaction> failed = List.copyOf(waiting);
        waiting.clear();
        failed.forEach(PagedTransaction::pagingFailed);
    }

    private void page() {
        repetition = null;
        if (!link.radio.isIdle()) {
            return;
        }
        if (attempts == ATTEMPTS || link.subscriber == null) {
            fail();
            return;
        }
        attempts++;
        repetition = timers.start(T3113_NANOS, this::page);
        link.sendCommon(new RslMessage.PagingCommand(identity()));
    }

    /** The last attempt is by the identity that never changes: the mobile may have missed its latest temporary one. */
    private MobileIdentity identity() {
        return attempts == ATTEMPTS
                ? link.subscriber.imsi()
                : link.subscriber.tmsi().<MobileIdentity>map(tmsi -> tmsi).orElse(link.subscriber.imsi());
    }

    private void stop() {
        timers.cancel(repetition);
        repetition = null;
    }
}
