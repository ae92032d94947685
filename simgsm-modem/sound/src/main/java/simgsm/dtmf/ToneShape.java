package simgsm.dtmf;

import simgsm.tone.ToneLevel;

/**
 * The sound of a sent key.
 *
 * @param toneMillis at least 1
 * @param pauseMillis silence after the tone, at least 0
 * @param rowDbm0 level of the low-group tone, at most 3.14
 * @param columnDbm0 level of the high-group tone, at most 3.14
 * @param rampMillis raised-cosine rise and fall, 0 for hard edges. Lengths count at half amplitude (Q.24): the fall
 *     extends into the pause and is no longer than it
 */
public record ToneShape(int toneMillis, int pauseMillis, double rowDbm0, double columnDbm0, double rampMillis) {
    /** 100 ms tone, 100 ms pause, -10 dBm0 per tone, ramps of 5 ms. */
    public static final ToneShape STANDARD = new ToneShape(100, 100, -10, -10, 5);

    private static final int LONGEST_MILLIS = 3_600_000;

    public ToneShape {
        if (toneMillis < 1 || toneMillis > LONGEST_MILLIS) {
            throw new IllegalArgumentException("Tone of " + toneMillis + " ms (expected 1 to " + LONGEST_MILLIS + ")");
        }
        if (pauseMillis < 0 || pauseMillis > LONGEST_MILLIS) {
            throw new IllegalArgumentException(
                    "Pause of " + pauseMillis + " ms (expected 0 to " + LONGEST_MILLIS + ")");
        }
        requireLevel(rowDbm0);
        requireLevel(columnDbm0);
        if (!(rampMillis >= 0 && rampMillis <= toneMillis)) {
            throw new IllegalArgumentException(
                    "Ramps of " + rampMillis + " ms do not fit a tone of " + toneMillis + " ms");
        }
    }

    private static void requireLevel(double dbm0) {
        if (!(dbm0 >= -100 && dbm0 <= ToneLevel.FULL_SCALE_DBM0)) {
            throw new IllegalArgumentException("Level of " + dbm0 + " dBm0 (expected -100 to 3.14)");
        }
    }

    public ToneShape withMillis(int tone, int pause) {
        return new ToneShape(tone, pause, rowDbm0, columnDbm0, rampMillis);
    }

    public ToneShape withRamp(double millis) {
        return new ToneShape(toneMillis, pauseMillis, rowDbm0, columnDbm0, millis);
    }

    /** Raises the high tone by half of the twist and lowers the low one by it. @param decibels of high over low */
    public ToneShape withTwist(double decibels) {
        return new ToneShape(toneMillis, pauseMillis, rowDbm0 - decibels / 2, columnDbm0 + decibels / 2, rampMillis);
    }

    /** Sets both tones to one level. */
    public ToneShape withLevel(double dbm0) {
        return new ToneShape(toneMillis, pauseMillis, dbm0, dbm0, rampMillis);
    }
}
