package simgsm.center.bsc;

import java.util.concurrent.TimeUnit;

/**
 * Timers of the controller (TS 44.018, 11.1.2, with the values of osmo-bsc). T3105, which repeats PHYSICAL INFORMATION, runs in the
 * tower, as with osmo-bsc.
 */
public enum BscTimer {
    /** Waits for the mobile's first message after IMMEDIATE ASSIGNMENT. */
    T3101(3),
    /** Waits for HANDOVER COMPLETE or HANDOVER FAILURE after HANDOVER COMMAND. */
    T3103(5),
    /** Waits for ASSIGNMENT COMPLETE or ASSIGNMENT FAILURE after ASSIGNMENT COMMAND. */
    T10(6),
    /** Waits for the mobile's answer to CHANNEL MODE MODIFY; X13 of osmo-bsc. */
    MODE_OF_MOBILE(5),
    /** Waits for the tower's answer to MODE MODIFY REQUEST; X14 of osmo-bsc. */
    MODE_OF_TOWER(5),
    /** Waits for the end of the radio links after CHANNEL RELEASE. */
    T3109(5),
    /** From the end of the radio links to the end of the channel, so that the mobile has left it. */
    T3111(2),
    /** Seconds in IMMEDIATE ASSIGNMENT REJECT during which a mobile does not retry. */
    T3122(10),
    /** Limits a call's wait for a free traffic channel. */
    T11(5),
    /** Waits for the tower's answer to CHANNEL ACTIVATION. */
    ACTIVATION(4),
    /** Waits for the tower's answer to RF CHANNEL RELEASE. */
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
