package simgsm.abis;

import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * Keep-alive of one link by either side (CCM): sends a PING every 30 s, answers the peer's, and drops the link if
 * three are unanswered when the next is due.
 */
public final class KeepAlive {
    public static final long PERIOD_NANOS = TimeUnit.SECONDS.toNanos(30);
    private static final int MAX_UNANSWERED = 3;

    private final Timers timers;
    private final Consumer<CcmMessage> output;
    private final Consumer<String> drop;
    private Timer next;
    private int unanswered;

    /**
     * Not running yet.
     *
     * @param output sends a message to the peer
     * @param drop ends the link for the given reason
     */
    public KeepAlive(Timers timers, Consumer<CcmMessage> output, Consumer<String> drop) {
        this.timers = timers;
        this.output = output;
        this.drop = drop;
    }

    /** Begins with a new connection; the first PING follows after 30 s. */
    public void start() {
        stop();
        unanswered = 0;
        next = timers.start(PERIOD_NANOS, this::ping);
    }

    public void stop() {
        timers.cancel(next);
    }

    /** The peer has sent something: no PING counts as unanswered. */
    public void heard() {
        unanswered = 0;
    }

    /** True if the peer has left a PING unanswered for a whole period. */
    public boolean isSilent() {
        return unanswered > 1;
    }

    /** Answers a PING and counts a PONG; other messages are ignored. */
    public void receive(CcmMessage message) {
        if (message instanceof CcmMessage.Ping) {
            output.accept(new CcmMessage.Pong());
        } else if (message instanceof CcmMessage.Pong) {
            heard();
        }
    }

    private void ping() {
        if (unanswered == MAX_UNANSWERED) {
            drop.accept(MAX_UNANSWERED + " pings unanswered");
            return;
        }
        unanswered++;
        output.accept(new CcmMessage.Ping());
        next = timers.start(PERIOD_NANOS, this::ping);
    }
}
