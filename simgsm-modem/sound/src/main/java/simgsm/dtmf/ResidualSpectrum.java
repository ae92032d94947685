package simgsm.dtmf;

import java.util.Arrays;
import simgsm.tone.FourierTransform;

/**
 * The sound besides two tones between 560 and 3500 Hz and at the pitch of voices: the spectrum of the last 28 ms, and for comparison of the 28
 * ms before the tones began. One Fourier transform gives both, the later as its real, the earlier as its imaginary
 * part. Powers are on the scale of squared amplitudes.
 */
final class ResidualSpectrum {
    /** Samples in either window. */
    static final int LENGTH = 224;

    private static final int SIZE = FourierTransform.SIZE;
    private static final double BIN_HERTZ = 8000.0 / SIZE;
    private static final int LOWEST = (int) Math.ceil(560 / BIN_HERTZ);
    private static final int HIGHEST = (int) (3500 / BIN_HERTZ);
    /** 94 to 250 Hz: below it are mains, above it dial tones. */
    private static final int LOWEST_PITCH = 3;

    private static final int HIGHEST_PITCH = 8;
    /** Half the width of a line under this window. */
    private static final double HALF_LINE_HERTZ = 75;
    /** Ratio of a line's sum over all its bins to the highest of them. */
    private static final double LINE_OVER_PEAK = 1.5;
    /** Bins per evenness. */
    private static final int STRETCH = 8;
    /** Far below any sample's step; keeps logarithms finite. */
    private static final double TINY = 1e-12;

    /** Sound other than the tones, now. */
    double rest;
    /** Sound other than the tones, before they began. */
    double restBefore;
    /** Power at the row's tone before it began. */
    double rowBefore;
    /** Power at the column's tone before it began. */
    double columnBefore;
    /** The strongest spectral line other than the tones, now. */
    double line;

    double lineHertz;
    /** The strongest line at the pitch of voices, now. */
    double pitch;

    private final double[] window = new double[LENGTH];
    private final double[] re = new double[SIZE];
    private final double[] im = new double[SIZE];
    private final double[] during = new double[SIZE / 2];
    private final double[] before = new double[SIZE / 2];
    private final double scale;
    private double row;
    private double column;

    ResidualSpectrum() {
        double squares = 0;
        for (int i = 0; i < LENGTH; i++) {
            window[i] = 0.5 - 0.5 * Math.cos(2 * Math.PI * (i + 0.5) / LENGTH);
            squares += window[i] * window[i];
        }
        scale = 4 / (SIZE * squares);
    }

    /**
     * Measures all fields.
     *
     * @param end index after the newest sample
     * @param onset first sample of the tones, or slightly earlier
     */
    void measure(short[] samples, int end, int onset, double rowHertz, double columnHertz) {
        int late = end - LENGTH;
        int early = Math.max(0, onset - LENGTH);
        Arrays.fill(re, 0);
        Arrays.fill(im, 0);
        for (int i = 0; i < LENGTH; i++) {
            int at = FourierTransform.reversed(i);
            re[at] = window[i] * samples[late + i];
            im[at] = window[i] * samples[early + i];
        }
        FourierTransform.transform(re, im);
        row = rowHertz;
        column = columnHertz;
        for (int k = LOWEST_PITCH; k <= HIGHEST + 1; k++) {
            double a = (re[k] + re[SIZE - k]) / 2;
            double b = (im[k] - im[SIZE - k]) / 2;
            double c = (im[k] + im[SIZE - k]) / 2;
            double d = (re[SIZE - k] - re[k]) / 2;
            during[k] = scale * (a * a + b * b);
            before[k] = scale * (c * c + d * d);
        }
        sum(rowHertz, columnHertz);
    }

    private void sum(double rowHertz, double columnHertz) {
        rest = 0;
        restBefore = 0;
        rowBefore = 0;
        columnBefore = 0;
        line = 0;
        lineHertz = 0;
        pitch = 0;
        for (int k = LOWEST_PITCH; k <= HIGHEST_PITCH; k++) {
            pitch = Math.max(pitch, LINE_OVER_PEAK * during[k]);
        }
        int bins = 0;
        for (int k = LOWEST; k <= HIGHEST; k++) {
            double hertz = k * BIN_HERTZ;
            if (Math.abs(hertz - rowHertz) < HALF_LINE_HERTZ) {
                rowBefore += before[k];
            } else if (Math.abs(hertz - columnHertz) < HALF_LINE_HERTZ) {
                columnBefore += before[k];
            } else {
                bins++;
                rest += during[k];
                restBefore += before[k];
                findLine(k);
            }
        }
        // Assumes the same density of the rest in the tones' bins as in the others.
        double fill = (HIGHEST - LOWEST + 1.0) / bins;
        rest *= fill;
        restBefore *= fill;
    }

    private void findLine(int k) {
        double peak = LINE_OVER_PEAK * during[k];
        if (peak > line && during[k] >= during[k - 1] && during[k] >= during[k + 1]) {
            line = peak;
            lineHertz = k * BIN_HERTZ;
        }
    }

    /**
     * Evenness of the current spectrum besides the tones: geometric over arithmetic mean of its bins, in stretches of
     * 250 Hz so that colour does not count. Noise has about 0.6, line spectra much less.
     */
    double evenness() {
        double logarithms = 0;
        int bins = 0;
        for (int from = LOWEST; from + STRETCH <= HIGHEST + 1; from += STRETCH) {
            double sum = 0;
            double product = 1;
            int n = 0;
            for (int k = from; k < from + STRETCH; k++) {
                if (!isTones(k)) {
                    sum += during[k];
                    product *= during[k] + TINY;
                    n++;
                }
            }
            if (n > STRETCH / 2) {
                logarithms += Math.log(product) - n * Math.log(sum / n + TINY);
                bins += n;
            }
        }
        return Math.exp(logarithms / bins);
    }

    private boolean isTones(int k) {
        double hertz = k * BIN_HERTZ;
        return Math.abs(hertz - row) < HALF_LINE_HERTZ || Math.abs(hertz - column) < HALF_LINE_HERTZ;
    }
}
