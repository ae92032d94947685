package simgsm.center.msc.link;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import simgsm.air.MobileIdentity;
import simgsm.timer.Timer;

/** Pages the mobile of one link for the transactions that the network begins (TS 44.018, 3.3.2). */
public final class Paging {
    private static final int MAX_ATTEMPTS = 3;

    private final Link link;
    private final Set<PagedTransaction> waiting = new LinkedHashSet<>();
    private Timer repetition;
    private int attempts;
    private boolean isUnanswered;

    Paging(Link link) {
        this.link = link;
    }

    /** Connects the transaction at once if the mobile has a connection; else pages it once it is idle. */
    public void request(PagedTransaction transaction) {
        waiting.add(transaction);
        if (link.radio().isEstablished() && !link.radio().isReserved()) {
            answered();
        } else {
            resume();
        }
    }

    public void cancel(PagedTransaction transaction) {
        waiting.remove(transaction);
        if (waiting.isEmpty()) {
            stop();
        }
    }

    /** Pages for the waiting transactions if the mobile is idle and not being paged. */
    void resume() {
        if (!waiting.isEmpty() && link.radio().isIdle() && repetition == null) {
            attempts = 0;
            page();
        }
    }

    /** Handles a mobile's new connection, whatever its first message. */
    public void answered() {
        isUnanswered = false;
        end(PagedTransaction::radioConnected);
    }

    /** True if the mobile has not answered the last paging, so that it may be lost. */
    public boolean isUnanswered() {
        return isUnanswered;
    }

    public void fail() {
        end(PagedTransaction::pagingFailed);
    }

    private void end(Consumer<PagedTransaction> outcome) {
        stop();
        List<PagedTransaction> ended = List.copyOf(waiting);
        waiting.clear();
        ended.forEach(outcome);
    }

    private void page() {
        repetition = null;
        if (!link.radio().isIdle()) {
            return;
        }
        if (attempts == MAX_ATTEMPTS || !link.hasSubscriber()) {
            isUnanswered = true;
            fail();
            return;
        }
        attempts++;
        repetition = link.timers().start(NetworkTimer.T3113.nanos(), this::page);
        link.access().page(identity());
    }

    /** The TMSI; in the last attempt the IMSI, because the mobile may have missed its latest TMSI. */
    private MobileIdentity identity() {
        MobileIdentity imsi = link.subscriber().imsi();
        return attempts == MAX_ATTEMPTS
                ? imsi
                : link.subscriber().tmsi().<MobileIdentity>map(tmsi -> tmsi).orElse(imsi);
    }

    private void stop() {
        link.timers().cancel(repetition);
        repetition = null;
    }
}
