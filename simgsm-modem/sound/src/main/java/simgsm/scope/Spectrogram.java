package simgsm.scope;

import simgsm.tone.FourierTransform;

/**
 * The power of a sound over time and frequency: spectra of 256 samples under a Hann window, 31.25 Hz apart, a spectrum every
 * 10 ms.
 */
public final class Spectrogram {
    /** Interval of frequencies. */
    public static final double STEP_HERTZ = 31.25;
    /** Interval of spectra, in samples. */
    public static final int HOP_SAMPLES = 80;
    /** Lower levels are shown as this one. */
    public static final double FLOOR_DBM0 = -60;

    private static final int WINDOW = FourierTransform.SIZE;
    /** A sine of this peak has 0 dBm0: 3.14 dB below the largest sine (ITU-T G.711). */
    private static final double PEAK_OF_0_DBM0 = 32768 * Math.pow(10, -3.14 / 20);
    /** The mean of a Hann window. */
    private static final double WINDOW_MEAN = 0.5;

    private final float[][] dbm0;

    /** @param samples 8 kHz, oldest first */
    public Spectrogram(short[] samples) {
        int columns = samples.length < WINDOW ? 0 : (samples.length - WINDOW) / HOP_SAMPLES + 1;
        dbm0 = new float[columns][];
        for (int column = 0; column < columns; column++) {
            dbm0[column] = spectrum(samples, column * HOP_SAMPLES);
        }
    }

    /** The number of spectra; the first is of the oldest samples. */
    public int columns() {
        return dbm0.length;
    }

    /** The level of a sine of this frequency in a spectrum, 0 to 4000 Hz; for noise, its level in 31.25 Hz. */
    public double dbm0(int column, double hertz) {
        double bin = Math.max(0, Math.min(WINDOW / 2 - 2, hertz / STEP_HERTZ));
        int below = (int) bin;
        double share = bin - below;
        return (1 - share) * dbm0[column][below] + share * dbm0[column][below + 1];
    }

    private static float[] spectrum(short[] samples, int from) {
        double[] re = new double[WINDOW];
        double[] im = new double[WINDOW];
        for (int i = 0; i < WINDOW; i++) {
            double hann = WINDOW_MEAN * (1 - Math.cos(2 * Math.PI * i / WINDOW));
            re[FourierTransform.reversed(i)] = samples[from + i] * hann;
        }
        FourierTransform.transform(re, im);
        float[] levels = new float[WINDOW / 2];
        for (int bin = 0; bin < levels.length; bin++) {
            double peak = 2 * Math.hypot(re[bin], im[bin]) / (WINDOW * WINDOW_MEAN);
            levels[bin] = (float) Math.max(FLOOR_DBM0, 20 * Math.log10(Math.max(1e-9, peak / PEAK_OF_0_DBM0)));
        }
        return levels;
    }
}
