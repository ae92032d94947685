package simgsm.center.msc.sms;

import simgsm.air.ShortMessageControl;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.timer.Timer;

/** Sends CP-DATA at most three times, with TC1* after each (TS 24.011, 5.3.2). */
final class CpRepeater {
    private static final int MAX_SENDINGS = 3;

    private final Link link;
    private final Runnable expired;
    private final Runnable expiredAtLast;
    private ShortMessageControl.CpData data;
    private Timer repetition;
    private int sendings;

    /**
     * @param expired called after TC1*, {@link #send} repeats the message
     * @param expiredAtLast called after the last TC1*
     */
    CpRepeater(Link link, Runnable expired, Runnable expiredAtLast) {
        this.link = link;
        this.expired = expired;
        this.expiredAtLast = expiredAtLast;
    }

    void prepare(ShortMessageControl.CpData message) {
        data = message;
    }

    void send() {
        sendings++;
        repetition = link.timers().start(NetworkTimer.TC1.nanos(), sendings == MAX_SENDINGS ? expiredAtLast : expired);
        link.send(data);
    }

    void stop() {
        link.timers().cancel(repetition);
    }
}
