package simgsm.dtmf;

import simgsm.tone.ToneLevel;

/**
 * The first, cheap test, every fourth hop: prominence of one row's and one column's tone in the last 20 ms. Its
 * window is smooth: seven hops of the {@link ToneBank}, phase-aligned, under a Hann window. Sound 100 Hz or more off
 * a tone is attenuated by some 40 dB, which suppresses mains, dial tone and direct current.
 */
final class ToneGate {
    /** Tones below this level are ignored (Q.24: tones at -55 dBm0 must not be decoded). */
    static final double LEAST_DBM0 = -50;
    /** In both directions; a larger one is no key (later tests are stricter). */
    static final double MOST_TWIST_DB = 13;
    /** Hops from one look to the next. */
    static final int EVERY = 4;

    private static final float FLOOR = (float) Math.pow(ToneLevel.amplitude(LEAST_DBM0), 2);
    private static final float MOST_TWIST = (float) Math.pow(10, MOST_TWIST_DB / 10);
    /** Ratio of all four tones of a group to the strongest; a tone 1.8 % off gives 1.35. */
    private static final float MOST_SPREAD = 1.6f;
    /** Hops on either side of the window's middle. */
    private static final int ARM = 3;

    private static final int GROUP = 4;

    private final float[] cosines = new float[ToneBank.TONES * ARM];
    private final float[] sines = new float[ToneBank.TONES * ARM];
    private final float[] power = new float[ToneBank.TONES];

    ToneGate() {
        for (int k = 0; k < ToneBank.TONES; k++) {
            double turn = 2 * Math.PI * ToneBank.HERTZ[k] / ToneBank.HOPS_PER_SECOND;
            for (int j = 1; j <= ARM; j++) {
                double weight = Math.pow(Math.cos(Math.PI * j / (2 * ARM + 2)), 2) / (ARM + 1);
                cosines[k * ARM + j - 1] = (float) (weight * Math.cos(turn * j));
                sines[k * ARM + j - 1] = (float) (weight * Math.sin(turn * j));
            }
        }
    }

    /** Tests a hop of the bank and the six before it. @return ordinal of the prominent key, or -1 */
    int look(ToneBank bank, int newest) {
        int row = strongest(bank, newest, 0);
        if (!standsOut(row)) {
            return -1;
        }
        int column = strongest(bank, newest, GROUP);
        float weaker = Math.min(power[row], power[column]);
        boolean found =
                standsOut(column) && weaker > FLOOR && Math.max(power[row], power[column]) < MOST_TWIST * weaker;
        return found ? GROUP * row + column - GROUP : -1;
    }

    /** The tones of a hop and the six before it, and their required levels. */
    ToneLevels levels(ToneBank bank, int newest) {
        double row = Math.sqrt(power[strongest(bank, newest, 0)]);
        double column = Math.sqrt(power[strongest(bank, newest, GROUP)]);
        double[] amplitudes = new double[ToneBank.TONES];
        for (int k = 0; k < ToneBank.TONES; k++) {
            amplitudes[k] = Math.sqrt(power[k]);
        }
        return new ToneLevels(amplitudes, least(column), least(row), this::standsOut);
    }

    /** Required level of a tone by the other group's strongest. */
    private static double least(double other) {
        return Math.max(LEAST_DBM0, ToneLevel.dbm0(other) - MOST_TWIST_DB);
    }

    private boolean standsOut(int tone) {
        int k = tone - tone % GROUP;
        return power[k] + power[k + 1] + power[k + 2] + power[k + 3] < MOST_SPREAD * power[tone];
    }

    /** Measures a group. @return its strongest tone */
    private int strongest(ToneBank bank, int newest, int group) {
        int best = group;
        for (int k = group; k < group + GROUP; k++) {
            power[k] = power(bank.real[k], bank.imaginary[k], newest - ARM, k * ARM);
            best = power[k] > power[best] ? k : best;
        }
        return best;
    }

    private float power(float[] re, float[] im, int middle, int weights) {
        float x = re[middle] / (ARM + 1);
        float y = im[middle] / (ARM + 1);
        for (int j = 1; j <= ARM; j++) {
            float c = cosines[weights + j - 1];
            float s = sines[weights + j - 1];
            x += c * (re[middle + j] + re[middle - j]) + s * (im[middle + j] - im[middle - j]);
            y += c * (im[middle + j] + im[middle - j]) - s * (re[middle + j] - re[middle - j]);
        }
        return x * x + y * y;
    }
}
