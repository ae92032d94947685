package simgsm.dtmf;

import java.util.Arrays;

/**
 * The first, cheap test, every fourth hop: do one row's and one column's tone stand out in the last 20 ms? Its window is smooth:
 * seven hops of the {@link ToneBank}, turned into step with one another, under a Hann window. What lies 100 Hz or more
 * beside a tone is some 40 dB down, so that mains, dial tone and direct current do not reach it.
 */
final class ToneGate {
    /** Tones below this level are ignored (Q.24: tones at -55 dBm0 must not be decoded). */
    static final double LEAST_DBM0 = -50;
    /** Either way; what lies beyond is no key (the finer tests are stricter). */
    static final double MOST_TWIST_DB = 13;

    private static final float FLOOR = (float) square(ToneLevel.amplitude(LEAST_DBM0));
    private static final float MOST_TWIST = (float) Math.pow(10, MOST_TWIST_DB / 10);
    /** All four tones of a group together against the strongest of them; 1.8 % beside its own, a tone gives 1.35. */
    private static final float MOST_SPREAD = 1.6f;
    /** Hops on either side of the window's middle. */
    private static final int ARM = 3;

    /** Hops from one look to the next, a power of two. */
    private static final int EVERY = 4;

    private static final int ROWS = 4;
    private static final int MOST_LOOKS = ToneBank.MOST_HOPS / EVERY + 1;

    private int first;
    private int looks;
    private int lastKey = -1;
    private float lastLoudness;
    private final float[] cosines = new float[ToneBank.TONES * ARM];
    private final float[] sines = new float[ToneBank.TONES * ARM];
    private final float[][] power = new float[ToneBank.TONES][MOST_LOOKS];
    private final float[] row = new float[MOST_LOOKS];
    private final float[] column = new float[MOST_LOOKS];
    private final float[] rowMargin = new float[MOST_LOOKS];
    private final float[] columnMargin = new float[MOST_LOOKS];
    /** Positive where two tones stand out. */
    private final float[] margin = new float[MOST_LOOKS];

    private final int[] keys = new int[MOST_LOOKS];
    /** The tones' amplitudes at the newest look. */
    private final double[] newest = new double[ToneBank.TONES];

    ToneGate() {
        for (int k = 0; k < ToneBank.TONES; k++) {
            double turn = 2 * Math.PI * ToneBank.HERTZ[k] / ToneBank.HOPS_PER_SECOND;
            for (int j = 1; j <= ARM; j++) {
                double weight = square(Math.cos(Math.PI * j / (2 * ARM + 2))) / (ARM + 1);
                cosines[k * ARM + j - 1] = (float) (weight * Math.cos(turn * j));
                sines[k * ARM + j - 1] = (float) (weight * Math.sin(turn * j));
            }
        }
    }

    private static double square(double x) {
        return x * x;
    }

    /** Looks at the newest hops of the bank, at those whose number is a multiple of {@link #EVERY}. */
    void accept(ToneBank bank, long firstHop, int hops) {
        if (looks > 0) {
            lastKey = keys[looks - 1];
            lastLoudness = row[looks - 1] * column[looks - 1];
        }
        first = (int) (-firstHop & EVERY - 1);
        looks = (hops - first + EVERY - 1) / EVERY;
        for (int k = 0; k < ToneBank.TONES; k++) {
            window(bank.real[k], bank.imaginary[k], ToneBank.HISTORY + first, k, power[k]);
        }
        strongest(power[0], power[1], power[2], power[3], row, looks);
        strongest(power[4], power[5], power[6], power[7], column, looks);
        spread(power[0], power[1], power[2], power[3], row, rowMargin, looks);
        spread(power[4], power[5], power[6], power[7], column, columnMargin, looks);
        margin(row, column, rowMargin, columnMargin, margin, looks);
        for (int look = 0; look < looks; look++) {
            keys[look] = keyAt(look);
        }
        for (int k = 0; looks > 0 && k < ToneBank.TONES; k++) {
            newest[k] = Math.sqrt(power[k][looks - 1]);
        }
    }

    /** The tones of the newest look and what they had to reach. */
    ToneLevels levels() {
        return new ToneLevels(newest, least(ROWS), least(0), tone -> standsOut(tone / ROWS * ROWS, newest[tone]));
    }

    /** What a group's tone has to reach, from the other group's first tone on. */
    private double least(int other) {
        double most = 0;
        for (int k = other; k < other + ROWS; k++) {
            most = Math.max(most, newest[k]);
        }
        return Math.max(LEAST_DBM0, ToneLevel.dbm0(Math.max(1, most)) - MOST_TWIST_DB);
    }

    private boolean standsOut(int group, double amplitude) {
        double together = 0;
        for (int k = group; k < group + ROWS; k++) {
            together += square(newest[k]);
        }
        return together < MOST_SPREAD * square(amplitude);
    }

    /** The key, as its ordinal, whose tones stood out at the last look up to hop b, or -1. */
    int key(int b) {
        return b < first ? lastKey : keys[(b - first) / EVERY];
    }

    /** How loud that key's tones were then: the product of their powers. */
    float loudness(int b) {
        int look = (b - first) / EVERY;
        return b < first ? lastLoudness : row[look] * column[look];
    }

    private int keyAt(int look) {
        return margin[look] > 0 ? 4 * strongest(look, 0, row[look]) + strongest(look, ROWS, column[look]) : -1;
    }

    void clear() {
        looks = 0;
        lastKey = -1;
        Arrays.fill(newest, 0);
    }

    private int strongest(int b, int from, float most) {
        int k = 0;
        while (k < 3 && power[from + k][b] < most) {
            k++;
        }
        return k;
    }

    private void window(float[] re, float[] im, int newest, int tone, float[] power) {
        float c1 = cosines[tone * ARM];
        float c2 = cosines[tone * ARM + 1];
        float c3 = cosines[tone * ARM + 2];
        float s1 = sines[tone * ARM];
        float s2 = sines[tone * ARM + 1];
        float s3 = sines[tone * ARM + 2];
        int n = looks;
        for (int look = 0; look < n; look++) {
            int m = newest - ARM + EVERY * look;
            float x = 0.25f * re[m]
                    + c1 * (re[m + 1] + re[m - 1])
                    + c2 * (re[m + 2] + re[m - 2])
                    + c3 * (re[m + 3] + re[m - 3])
                    + s1 * (im[m + 1] - im[m - 1])
                    + s2 * (im[m + 2] - im[m - 2])
                    + s3 * (im[m + 3] - im[m - 3]);
            float y = 0.25f * im[m]
                    + c1 * (im[m + 1] + im[m - 1])
                    + c2 * (im[m + 2] + im[m - 2])
                    + c3 * (im[m + 3] + im[m - 3])
                    - s1 * (re[m + 1] - re[m - 1])
                    - s2 * (re[m + 2] - re[m - 2])
                    - s3 * (re[m + 3] - re[m - 3]);
            power[look] = x * x + y * y;
        }
    }

    private static void strongest(float[] p0, float[] p1, float[] p2, float[] p3, float[] most, int hops) {
        for (int b = 0; b < hops; b++) {
            most[b] = Math.max(Math.max(p0[b], p1[b]), Math.max(p2[b], p3[b]));
        }
    }

    private static void spread(float[] p0, float[] p1, float[] p2, float[] p3, float[] most, float[] margin, int hops) {
        for (int b = 0; b < hops; b++) {
            margin[b] = MOST_SPREAD * most[b] - (p0[b] + p1[b] + p2[b] + p3[b]);
        }
    }

    private static void margin(float[] row, float[] column, float[] inRow, float[] inColumn, float[] margin, int hops) {
        for (int b = 0; b < hops; b++) {
            float spread = Math.min(inRow[b], inColumn[b]);
            float twist = Math.min(MOST_TWIST * row[b] - column[b], MOST_TWIST * column[b] - row[b]);
            float level = Math.min(row[b], column[b]) - FLOOR;
            margin[b] = Math.min(Math.min(spread, twist), level);
        }
    }
}
