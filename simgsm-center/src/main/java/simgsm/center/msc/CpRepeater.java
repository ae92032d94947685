package simgsm.center.msc;

import java.time.Duration;
import simgsm.air.ShortMessageControl;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** Sends CP-DATA until CP-ACK comes, three times at most (TS 24.011, 5.3.2 and 10.2: TC1*). */
final class CpRepeater {
    private static final long TC1_NANOS = Duration.ofSeconds(10).toNanos();
    private static final int MAX_SENDINGS = 3;

    private final Link link;
    private final Timers timers;
    private final Runnable givenUp;
    private ShortMessageControl.CpData data;
    private Timer repetition;
    private int sendings;

    CpRepeater(Link link, Timers timers, Runnable givenUp) {
        this.link = link;
        this.timers = timers;
        this.givenUp = givenUp;
    }

    void send(ShortMessageControl.CpData message) {
        data = message;
        sendings = 0;
        sendAgain();
    }

    boolean isWaiting() {
        return repetition != null;
    }

    void stop() {
        timers.cancel(repetition);
        repetition = null;
    }

    private void sendAgain() {
        repetition = null;
        if (sendings == MAX_SENDINGS) {
            givenUp.run();
            return;
        }
        sendings++;
        repetition = timers.start(TC1_NANOS, this::sendAgain);
        link.send(data);
    }
}
