package simgsm.modem;

import simgsm.dtmf.DtmfKey;
import simgsm.speech.SpeechCodec;

/**
 * Detects keys that may have been lost with the speech, as in a handover: no order may be made of the keys around
 * them. A key inside an outage of 60 ms or more leaves a longer interval between its neighbours. In an outage of 100
 * ms or more, which fading copies of the last frame replace, a key may be heard twice.
 */
final class OutageWatch {
    /** 3 frames; shorter outages leave enough of a key, whose tone lasts 65 ms or more. */
    private static final int LEAST_FRAMES = 3;
    /** Shorter outages double no key. */
    private static final int LEAST_DOUBLING_FRAMES = 5;
    /** A doubled key is heard within 200 ms after the outage. */
    private static final int DOUBLING_SAMPLES = 1_600;
    /**
     * An interval with a lost key is twice as long as the others; one with a late second key, after the outage cut
     * its beginning, is shorter than this.
     */
    private static final double LONGER = 1.7;
    /** 340 ms at 8 kHz: 1.7 times the interval of the phones here. */
    private static final int LONG_SAMPLES = 2_720;

    private long samples;
    private long lastKey;
    /** Null before the first key of the call. */
    private DtmfKey last;

    /** Until this sample a key may be heard twice. */
    private long doublingEnd;
    /** Shortest interval between two keys of this call. */
    private long shortest;

    private boolean isOutage;
    /** True if the previous interval had an outage: a key decided late shortens the next interval. */
    private boolean wasOutage;

    OutageWatch() {
        reset();
    }

    /** Starts a call. */
    void reset() {
        samples = 0;
        last = null;
        doublingEnd = 0;
        shortest = Long.MAX_VALUE;
        isOutage = false;
        wasOutage = false;
    }

    /** This number of consecutive frames did not arrive; their substitutes are heard next. */
    void lost(int frames) {
        isOutage |= frames >= LEAST_FRAMES;
        if (frames >= LEAST_DOUBLING_FRAMES) {
            doublingEnd = samples + (long) frames * SpeechCodec.SAMPLES_PER_FRAME + DOUBLING_SAMPLES;
        }
    }

    /** Counts heard samples, including substitutes of lost frames. */
    void heard(int count) {
        samples += count;
    }

    /** A key is decided. @return true if another one may have been lost before it, or it may repeat the last one */
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
