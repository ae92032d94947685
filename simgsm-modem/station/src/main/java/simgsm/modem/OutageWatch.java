package simgsm.modem;

import simgsm.dtmf.DtmfDigit;
import simgsm.speech.SpeechCodec;

/**
 * Detects keys that may have been lost or doubled with lost speech, as in a handover: no order may be made of the
 * keys around them. A key inside an outage leaves a longer interval between its neighbours, from start to start of their tones. In
 * an outage, which fading copies of the last frame replace, a key may be heard twice.
 */
final class OutageWatch {
    /** An outage of 3 frames, 60 ms, hides any key: it leaves too little of the shortest one, 65 ms. */
    private static final int LEAST_FRAMES = 3;
    /** 2 frames hide a key of the phones here that they hit behind its first 20 ms, the more rarely the longer it is. */
    private static final int LEAST_HIDING_FRAMES = 2;
    /** An outage so long may double any key. */
    private static final int LEAST_DOUBLING_FRAMES = 5;
    /** A doubled key is heard within 200 ms after the outage; until then disturbed tones are likely a key's. */
    private static final int NEAR_SAMPLES = 1_600;
    /**
     * An interval with a lost key is twice as long as the others; one with a late second key, after the outage cut
     * its beginning, is shorter than this.
     */
    private static final double LONGER = 1.7;
    /** One lost key makes no interval as long as this; the pauses of a person do. */
    private static final double TOO_LONG = 2.5;
    /** The least tone and pause of a key, 130 ms (TS 23.014): what begins earlier may be the rest of the key before. */
    private static final int LEAST_INTERVAL = 1_040;
    /** The same as a part of the shortest interval, as long tones leave a later rest. */
    private static final double SHORTER = 0.65;
    /** 340 ms at 8 kHz: 1.7 times the interval of the phones here. */
    private static final int LONG_SAMPLES = 2_720;

    private static final long UNKNOWN = Long.MAX_VALUE;

    private long samples;
    /** Null before the first key of the call. */
    private DtmfDigit last;

    /** Until this sample a key may be heard twice. */
    private long doublingEnd;
    /** Until this sample tones may be disturbed. */
    private long nearEnd;
    /** Shortest interval between two keys of this call, without a loss. */
    private long shortest;

    /** Longest outage since the last key, in frames. */
    private int outage;
    /** The same for the previous interval: a key that begins late shortens the next one. */
    private int outageBefore;

    OutageWatch() {
        reset();
    }

    /** Starts a call. */
    void reset() {
        samples = 0;
        last = null;
        doublingEnd = 0;
        nearEnd = 0;
        shortest = UNKNOWN;
        outage = 0;
        outageBefore = 0;
    }

    /** This number of consecutive frames did not arrive; their substitutes are heard next. */
    void lost(int frames) {
        outage = Math.max(outage, frames);
        long end = samples + (long) frames * SpeechCodec.SAMPLES_PER_FRAME + NEAR_SAMPLES;
        if (frames >= LEAST_DOUBLING_FRAMES) {
            doublingEnd = end;
        }
        if (frames >= LEAST_HIDING_FRAMES) {
            nearEnd = end;
        }
    }

    /** Counts heard samples, including substitutes of lost frames. */
    void heard(int count) {
        samples += count;
    }

    /** True in an outage of 40 ms or more and up to 200 ms after it. */
    boolean isNear() {
        return samples < nearEnd;
    }

    /** A key is decided. @return true if another one may have been lost before it, or it may repeat the last one */
    boolean keyDecided(DtmfDigit digit) {
        boolean isSuspect = false;
        if (last != null) {
            long interval = digit.startedAtSample() - last.startedAtSample();
            isSuspect = isLost(interval) || digit.key() == last.key() && isDoubled(interval);
            if (outage == 0 && outageBefore == 0) {
                shortest = Math.min(shortest, interval);
            }
        }
        last = digit;
        outageBefore = outage;
        outage = 0;
        return isSuspect;
    }

    private boolean isDoubled(long interval) {
        boolean isShort = interval < LEAST_INTERVAL || shortest != UNKNOWN && interval < SHORTER * shortest;
        return samples < doublingEnd || outage + outageBefore > 0 && isShort;
    }

    private boolean isLost(long interval) {
        boolean isLonger = interval > LONGER * shortest;
        return outage >= LEAST_FRAMES && (isLonger || interval > LONG_SAMPLES)
                || outage >= LEAST_HIDING_FRAMES && isLonger && interval < TOO_LONG * shortest;
    }
}
