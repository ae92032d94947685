package simgsm.modem;

import simgsm.dtmf.DtmfKey;
import simgsm.speech.SpeechCodec;

/**
 * Finds out whether a key may have been lost with the speech, as in a handover: then no order may be made of the keys around it.
 * A key that falls into an outage of 60 ms or more leaves a longer interval between the keys beside it.
 * In one of 100 ms or more, for which the last frame before it stands in, weaker and weaker, a key may be heard twice.
 */
final class OutageWatch {
    /** Shorter outages leave enough of a key, whose tone is 65 ms or longer; 3 frames. */
    private static final int LEAST_FRAMES = 3;
    /** Shorter outages double no key. */
    private static final int LEAST_DOUBLING_FRAMES = 5;
    /** A key that is heard twice comes within 200 ms after the outage. */
    private static final int DOUBLING_SAMPLES = 1_600;
    /**
     * An interval with a lost key has twice the length of the others; one whose second key is decided late, because the outage
     * took its beginning, has less than this.
     */
    private static final double LONGER = 1.7;
    /** 340 ms at 8 kHz: 1.7 times the interval of the phones here. */
    private static final int LONG_SAMPLES = 2_720;

    private long samples;
    private long lastKey;
    /** Null before the first key of the call. */
    private DtmfKey last;

    /** Until then a key may be heard twice. */
    private long doublingEnd;
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
        last = null;
        doublingEnd = 0;
        shortest = Long.MAX_VALUE;
        isOutage = false;
        wasOutage = false;
    }

    /** This number of frames in a row did not arrive; their substitutes are heard next. */
    void lost(int frames) {
        isOutage |= frames >= LEAST_FRAMES;
        if (frames >= LEAST_DOUBLING_FRAMES) {
            doublingEnd = samples + (long) frames * SpeechCodec.SAMPLES_PER_FRAME + DOUBLING_SAMPLES;
        }
    }

    /** Counts samples that were heard, substitutes of lost frames included. */
    void heard(int count) {
        samples += count;
    }

    /** A key is decided. @return whether another one may have been lost before it, or this may be the last one again */
    boolean keyDecided(DtmfKey key) {
        long interval = samples - lastKey;
        boolean isLost = isOutage && last != null && interval > Math.min(LONG_SAMPLES, LONGER * shortest);
        boolean isDoubled = key == last && samples < doublingEnd;
        if (last != null && !isOutage && !wasOutage) {
            shortest = Math.min(shortest, interval);
        }
        last = key;
        lastKey = samples;
        wasOutage = isOutage;
        isOutage = false;
        return isLost || isDoubled;
    }
}
