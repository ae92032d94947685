package simgsm.modem;

/**
 * Finds out whether a key may have been lost with the speech, as in a handover: then no order may be made of the keys around it.
 * A key that falls into an outage of 60 ms or more leaves a longer interval between the keys beside it.
 */
final class OutageWatch {
    /** Shorter outages leave enough of a key, whose tone is 65 ms or longer; 3 frames. */
    private static final int LEAST_FRAMES = 3;
    /**
     * An interval with a lost key has twice the length of the others; one whose second key is decided late, because the outage
     * took its beginning, has less than this.
     */
    private static final double LONGER = 1.7;
    /** 340 ms at 8 kHz: 1.7 times the interval of the phones here. */
    private static final int LONG_SAMPLES = 2_720;

    private long samples;
    private long lastKey;
    private boolean hasKey;
    /** The shortest interval between two keys of this call. */
    private long shortest;

    private boolean isOutage;
    /** Whether the interval before had an outage: a key that was decided late makes the next interval short. */
    private boolean wasOutage;

    OutageWatch() {
        reset();
    }

    /** A new call. */
    void reset() {
        samples = 0;
        hasKey = false;
        shortest = Long.MAX_VALUE;
        isOutage = false;
        wasOutage = false;
    }

    /** So many frames in a row did not arrive. */
    void lost(int frames) {
        isOutage |= frames >= LEAST_FRAMES;
    }

    /** So many samples have been heard, those that stand for lost frames included. */
    void heard(int count) {
        samples += count;
    }

    /** A key is decided. @return whether another one may have been lost before it */
    boolean keyDecided() {
        long interval = samples - lastKey;
        boolean isLost = isOutage && hasKey && interval > Math.min(LONG_SAMPLES, LONGER * shortest);
        if (hasKey && !isOutage && !wasOutage) {
            shortest = Math.min(shortest, interval);
        }
        hasKey = true;
        lastKey = samples;
        wasOutage = isOutage;
        isOutage = false;
        return isLost;
    }
}
