package simgsm.dtmf;

/**
 * What else sounds between 560 and 3500 Hz beside two tones: the spectrum of the 28 ms up to now, and for comparison that
 * of the 28 ms before the tones began. Both come from one Fourier transform, the later as its real, the earlier as its
 * imaginary part.
 */
final class Residue {
    static final int LENGTH = 224;
    private static final int SIZE = 256;
    private static final double BIN_HERTZ = 8000.0 / SIZE;
    private static final int LOWEST = (int) Math.ceil(560 / BIN_HERTZ);
    private static final int HIGHEST = (int) (3500 / BIN_HERTZ);
    /** A line under this window is so wide to either side. */
    private static final double HALF_LINE_HERTZ = 75;

    private final double[] window = new double[LENGTH];
    private final double[] re = new double[SIZE];
    private final double[] im = new double[SIZE];
    private final double[] cosine = new double[SIZE / 2];
    private final double[] sine = new double[SIZE / 2];
    private final int[] reversed = new int[SIZE];
    private final double scale;

    final double[] during = new double[SIZE / 2];
    final double[] before = new double[SIZE / 2];
    /** Squared amplitudes: what lies outside the two lines now, and what lay there before. */
    double rest;

    double restBefore;
    double tonesBefore;
    double rowBefore;
    double columnBefore;
    double strongest;
    double strongestHertz;
    double newLine;

    Residue() {
        double squares = 0;
        for (int i = 0; i < LENGTH; i++) {
            window[i] = 0.5 - 0.5 * Math.cos(2 * Math.PI * (i + 0.5) / LENGTH);
            squares += window[i] * window[i];
        }
        scale = 4 / (SIZE * squares);
        for (int i = 0; i < SIZE / 2; i++) {
            cosine[i] = Math.cos(2 * Math.PI * i / SIZE);
            sine[i] = -Math.sin(2 * Math.PI * i / SIZE);
        }
        for (int i = 0; i < SIZE; i++) {
            reversed[i] = Integer.reverse(i) >>> 24;
        }
    }

    /** @param end just behind the newest sample @param onset the first sample of the tones */
    void measure(short[] samples, int end, int onset, double rowHertz, double columnHertz) {
        int late = end - LENGTH;
        int early = Math.max(0, onset - LENGTH);
        java.util.Arrays.fill(re, 0);
        java.util.Arrays.fill(im, 0);
        for (int i = 0; i < LENGTH; i++) {
            re[reversed[i]] = window[i] * samples[late + i];
            im[reversed[i]] = window[i] * samples[early + i];
        }
        transform();
        rest = 0;
        restBefore = 0;
        tonesBefore = 0;
        rowBefore = 0;
        columnBefore = 0;
        strongest = 0;
        newLine = 0;
        int bins = 0;
        for (int k = LOWEST - 1; k <= HIGHEST + 1; k++) {
            double a = (re[k] + re[SIZE - k]) / 2;
            double b = (im[k] - im[SIZE - k]) / 2;
            double c = (im[k] + im[SIZE - k]) / 2;
            double d = (re[SIZE - k] - re[k]) / 2;
            during[k] = scale * (a * a + b * b);
            before[k] = scale * (c * c + d * d);
        }
        for (int k = LOWEST; k <= HIGHEST; k++) {
            double hertz = k * BIN_HERTZ;
            if (Math.abs(hertz - rowHertz) < HALF_LINE_HERTZ || Math.abs(hertz - columnHertz) < HALF_LINE_HERTZ) {
                tonesBefore += before[k];
                if (Math.abs(hertz - rowHertz) < HALF_LINE_HERTZ) {
                    rowBefore += before[k];
                } else {
                    columnBefore += before[k];
                }
                continue;
            }
            bins++;
            rest += during[k];
            restBefore += before[k];
            double old = Math.max(before[k], Math.max(before[k - 1], before[k + 1]));
            newLine = Math.max(newLine, 1.5 * (during[k] - 2 * old));
            if (during[k] > strongest && during[k] >= during[k - 1] && during[k] >= during[k + 1]) {
                strongest = during[k];
                strongestHertz = hertz;
            }
        }
        double fill = (HIGHEST - LOWEST + 1.0) / bins;
        rest *= fill;
        restBefore *= fill;
    }

    private void transform() {
        double[] x = re;
        double[] y = im;
        quarters(x, y);
        for (int half = 4; half < SIZE; half *= 2) {
            int stride = SIZE / 2 / half;
            for (int i = 0, t = 0; i < half; i++, t += stride) {
                double c = cosine[t];
                double s = sine[t];
                for (int a = i; a < SIZE; a += 2 * half) {
                    int b = a + half;
                    double u = x[b] * c - y[b] * s;
                    double v = y[b] * c + x[b] * s;
                    x[b] = x[a] - u;
                    y[b] = y[a] - v;
                    x[a] += u;
                    y[a] += v;
                }
            }
        }
    }

    /** The first two rounds, whose factors are 1 and -j. */
    private static void quarters(double[] x, double[] y) {
        for (int i = 0; i < SIZE; i += 4) {
            double ax = x[i] + x[i + 1];
            double ay = y[i] + y[i + 1];
            double bx = x[i] - x[i + 1];
            double by = y[i] - y[i + 1];
            double cx = x[i + 2] + x[i + 3];
            double cy = y[i + 2] + y[i + 3];
            double dx = x[i + 2] - x[i + 3];
            double dy = y[i + 2] - y[i + 3];
            x[i] = ax + cx;
            y[i] = ay + cy;
            x[i + 1] = bx + dy;
            y[i + 1] = by - dx;
            x[i + 2] = ax - cx;
            y[i + 2] = ay - cy;
            x[i + 3] = bx - dy;
            y[i + 3] = by + dx;
        }
    }
}
