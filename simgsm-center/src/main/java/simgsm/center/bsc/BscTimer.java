package simgsm.center.bsc;

import java.util.concurrent.TimeUnit;

/**
 * Timers of the controller (TS 44.018, 11.1.2, with the values of osmo-bsc). T3105, which repeats PHYSICAL INFORMATION, runs in the
 * tower, as with osmo-bsc.
 */
public enum BscTimer {
    /** IMMEDIATE ASSIGNMENT is not followed by the mobile's first message. */
    T3101(3),
    /** HANDOVER COMMAND is not followed by HANDOVER COMPLETE or HANDOVER FAILURE. */
    T3103(5),
    /** ASSIGNMENT COMMAND is not followed by ASSIGNMENT COMPLETE or ASSIGNMENT FAILURE. */
    T10(6),
    /** CHANNEL MODE MODIFY is not acknowledged by the mobile; X13 of osmo-bsc. */
    MODE_OF_MOBILE(5),
    /** MODE MODIFY REQUEST is not answered by the tower; X14 of osmo-bsc. */
    MODE_OF_TOWER(5),
    /** After CHANNEL RELEASE the tower has not confirmed that the radio links are down. */
    T3109(5),
    /** From the end of the radio links to the end of the channel, so that the mobile has left it. */
    T3111(2),
    /** Seconds in IMMEDIATE ASSIGNMENT REJECT for which a mobile does not try again. */
    T3122(10),
    /** A call waits for a free traffic channel. */
    T11(5),
    /** The tower does not answer CHANNEL ACTIVATION. */
    ACTIVATION(4),
    /** The tower does not acknowledge RF CHANNEL RELEASE. */
    RF_RELEASE(4);

    private final int seconds;

    BscTimer(int seconds) {
        this.seconds = seconds;
    }

    public int seconds() {
        return seconds;
    }

    public long nanos() {
        return TimeUnit.SECONDS.toNanos(seconds);
    }
}
