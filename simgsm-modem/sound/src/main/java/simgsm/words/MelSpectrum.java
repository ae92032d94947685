package simgsm.words;

import simgsm.tone.FourierTransform;

/**
 * The spectrum of a frame of speech on the mel scale as in ETSI ES 201 108, 4.2: pre-emphasis 0.97, Hamming window,
 * Fourier transform of 256 points, magnitudes in {@value #BANDS} triangular bands from 64 to 4 000 Hz. Any thread may use
 * it.
 */
final class MelSpectrum {
    static final int BANDS = 23;
    /** Samples of a frame, 25 ms. */
    static final int FRAME = 200;

    private static final int SIZE = FourierTransform.SIZE;
    private static final double PRE_EMPHASIS = 0.97;
    static final double LOWEST_HERTZ = 64;
    private static final double HIGHEST_HERTZ = 4000;
    private static final double[] WINDOW = new double[FRAME];
    /** Mel from the centre of a band to that of the next. */
    static final double STEP = (mel(HIGHEST_HERTZ) - mel(LOWEST_HERTZ)) / (BANDS + 1);

    /** Bins at the centres of the bands, with the edges of the first and the last. */
    private static final int[] CENTERS = new int[BANDS + 2];

    static {
        for (int i = 0; i < FRAME; i++) {
            WINDOW[i] = 0.54 - 0.46 * Math.cos(2 * Math.PI * i / (FRAME - 1));
        }
        for (int i = 0; i < CENTERS.length; i++) {
            CENTERS[i] = (int) Math.round(hertz(mel(LOWEST_HERTZ) + STEP * i) / 8000 * SIZE);
        }
    }

    private MelSpectrum() {}

    static double mel(double hertz) {
        return 2595 * Math.log10(1 + hertz / 700);
    }

    static double hertz(double mel) {
        return 700 * (Math.pow(10, mel / 2595) - 1);
    }

    /** @param samples a frame and, before it, the sample that precedes it: {@value #FRAME} + 1 values */
    static float[] of(double[] samples) {
        double[] re = new double[SIZE];
        double[] im = new double[SIZE];
        for (int i = 0; i < FRAME; i++) {
            re[FourierTransform.reversed(i)] = WINDOW[i] * (samples[i + 1] - PRE_EMPHASIS * samples[i]);
        }
        FourierTransform.transform(re, im);
        float[] bands = new float[BANDS];
        for (int k = 1; k <= BANDS; k++) {
            int left = CENTERS[k - 1];
            int center = CENTERS[k];
            int right = CENTERS[k + 1];
            double sum = 0;
            for (int bin = left; bin <= right; bin++) {
                double weight = bin <= center
                        ? (bin - left + 1.0) / (center - left + 1)
                        : 1 - (bin - center) / (double) (right - center + 1);
                sum += weight * Math.hypot(re[bin], im[bin]);
            }
            bands[k - 1] = (float) sum;
        }
        return bands;
    }
}
