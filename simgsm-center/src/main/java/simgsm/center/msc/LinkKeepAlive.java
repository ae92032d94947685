package simgsm.center.msc;

import java.time.Duration;
import simgsm.abis.CcmMessage;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** Asks each peer who it is, does not keep who does not say it, and asks every half minute whether it still lives. */
final class LinkKeepAlive {
    private static final long PERIOD_NANOS = Duration.ofSeconds(30).toNanos();
    private static final int MAX_UNANSWERED = 3;
    /** How long a peer may take to say what it is, or to register: a port scanner says nothing. */
    static final long IDENTITY_NANOS = Duration.ofSeconds(15).toNanos();

    private final Link link;
    private final Timers timers;
    private Timer next;
    private Timer anonymity;
    private int unanswered;

    LinkKeepAlive(Link link, Timers timers) {
        this.link = link;
        this.timers = timers;
    }

    void start() {
        link.sendCcm(new CcmMessage.IdentityRequest());
        next = timers.start(PERIOD_NANOS, this::ping);
        anonymity = timers.start(IDENTITY_NANOS, () -> link.drop("has not said who it is"));
    }

    /** The peer has said who it is. */
    void identified() {
        timers.cancel(anonymity);
    }

    void stop() {
        timers.cancel(anonymity);
        timers.cancel(next);
    }

    void receive(CcmMessage message) {
        if (message instanceof CcmMessage.Ping) {
            link.sendCcm(new CcmMessage.Pong());
        } else if (message instanceof CcmMessage.Pong) {
            unanswered = 0;
        } else if (message instanceof CcmMessage.IdentityResponse) {
            identified();
            link.sendCcm(new CcmMessage.IdentityAcknowledge());
        }
    }

    private void ping() {
        if (unanswered == MAX_UNANSWERED) {
            link.drop(MAX_UNANSWERED + " pings unanswered");
            return;
        }
        unanswered++;
        link.sendCcm(new CcmMessage.Ping());
        next = timers.start(PERIOD_NANOS, this::ping);
    }
}
