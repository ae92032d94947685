package simgsm.dtmf;

import java.util.Arrays;

/**
 * The eight tones mixed down to zero frequency: every {@link #HOP} samples, for each tone k, the complex amplitude
 * near it, over 40 samples under a triangular window,
 * <pre>
 *   z[k][n] = 1/10 sum over i = -20 .. 19 of x[20 n + i] (20 - |i + 1/2|) / 20 e^(-j w[k] (i + 1/2))
 * </pre>
 * so a sine of peak A at the tone gives |z| = A. The triangle's zeros are at all multiples of 400 Hz from the tone,
 * which the hop of 400 Hz would alias onto it.
 *
 * <p>Made for speed: many hops at a time, folded about the window's middle (cosine sums use the even part, sine sums
 * the odd part), with inner loops over hops, which the compiler vectorizes. The sums do not depend on how many hops
 * are taken at a time.
 *
 * <p>Hops are kept in arrays with {@link #HISTORY} earlier ones before the newest.
 */
final class ToneBank {
    static final int HOP = 20;
    static final int HOPS_PER_SECOND = 400;
    static final int MOST_HOPS = 256;
    static final int HISTORY = 64;
    static final int TONES = 8;

    static final double[] HERTZ = {697, 770, 852, 941, 1209, 1336, 1477, 1633};

    private static final double[][] LEAKS = new double[TONES][TONES];

    static {
        for (int k = 0; k < TONES; k++) {
            for (int m = 0; m < TONES; m++) {
                LEAKS[k][m] = leak(HERTZ[k] - HERTZ[m]);
            }
        }
    }

    private static final int STRIDE = MOST_HOPS + 16;

    /** {@code [tone][HISTORY + hop]} */
    final float[][] real = new float[TONES][HISTORY + MOST_HOPS];

    final float[][] imaginary = new float[TONES][HISTORY + MOST_HOPS];

    private final float[][] cosines = new float[TONES][HOP];
    private final float[][] sines = new float[TONES][HOP];
    /** Row i, column b: the sample i + 1/2 after the middle of hop b's window. */
    private final float[] after = new float[HOP * STRIDE];

    /** The mirror sample, i + 1/2 before the middle. */
    private final float[] before = new float[HOP * STRIDE];

    private final float[] even = new float[HOP * STRIDE];
    private final float[] odd = new float[HOP * STRIDE];
    private final float[] sum = new float[MOST_HOPS];

    ToneBank() {
        for (int k = 0; k < TONES; k++) {
            double step = 2 * Math.PI * HERTZ[k] / 8000;
            for (int i = 0; i < HOP; i++) {
                double weight = (HOP - (i + 0.5)) / HOP / 10;
                cosines[k][i] = (float) (weight * Math.cos(step * (i + 0.5)));
                sines[k][i] = (float) (-weight * Math.sin(step * (i + 0.5)));
            }
        }
    }

    /** Adds {@code hops} hops of {@code samples[at..at + 20 hops)}; the 20 samples before them are required, too. */
    void accept(short[] samples, int at, int hops) {
        load(samples, at, hops);
        for (int i = 0; i < HOP; i++) {
            fold(after, before, even, odd, i * STRIDE, hops);
        }
        for (int k = 0; k < TONES; k++) {
            mix(even, cosines[k], real[k], hops);
            mix(odd, sines[k], imaginary[k], hops);
        }
    }

    /** Clears the history. */
    void clear() {
        for (int k = 0; k < TONES; k++) {
            Arrays.fill(real[k], 0);
            Arrays.fill(imaginary[k], 0);
        }
    }

    /** Squared amplitude of one tone in one hop. */
    float power(int tone, int at) {
        float x = real[tone][at];
        float y = imaginary[tone][at];
        return x * x + y * y;
    }

    /** Gain of the triangle for a sine at a distance from its tone. */
    static double leak(double hertz) {
        double x = Math.PI * hertz / HOPS_PER_SECOND;
        double sinc = x == 0 ? 1 : Math.sin(x) / x;
        return sinc * sinc;
    }

    /** Leakage of one tone into another. */
    static double leakBetween(int tone, int other) {
        return LEAKS[tone][other];
    }

    /** Makes the newest hops history. */
    void shift(int hops) {
        for (int k = 0; k < TONES; k++) {
            System.arraycopy(real[k], hops, real[k], 0, HISTORY);
            System.arraycopy(imaginary[k], hops, imaginary[k], 0, HISTORY);
        }
    }

    private void load(short[] samples, int at, int hops) {
        for (int i = 0; i < HOP; i += 5) {
            spread(samples, at + i, after, i * STRIDE, hops);
        }
        for (int i = 0; i < HOP; i++) {
            int mirrored = (HOP - 1 - i) * STRIDE;
            before[mirrored] = samples[at - HOP + i];
            System.arraycopy(after, i * STRIDE, before, mirrored + 1, hops - 1);
        }
    }

    private static void spread(short[] samples, int at, float[] rows, int to, int hops) {
        for (int b = 0; b < hops; b++) {
            int from = at + HOP * b;
            rows[to + b] = samples[from];
            rows[to + STRIDE + b] = samples[from + 1];
            rows[to + 2 * STRIDE + b] = samples[from + 2];
            rows[to + 3 * STRIDE + b] = samples[from + 3];
            rows[to + 4 * STRIDE + b] = samples[from + 4];
        }
    }

    /** All arrays have the same index, as vectorizing requires. */
    private static void fold(float[] after, float[] before, float[] even, float[] odd, int at, int hops) {
        for (int b = 0; b < hops; b++) {
            float u = after[at + b];
            float v = before[at + b];
            even[at + b] = u + v;
            odd[at + b] = u - v;
        }
    }

    /** Five terms at a time, at constant offsets: as much as the compiler vectorizes. */
    private void mix(float[] x, float[] c, float[] to, int hops) {
        first(x, c[0], c[1], c[2], c[3], c[4], sum, hops);
        add(x, 5 * STRIDE, c[5], c[6], c[7], c[8], c[9], sum, hops);
        add(x, 10 * STRIDE, c[10], c[11], c[12], c[13], c[14], sum, hops);
        add(x, 15 * STRIDE, c[15], c[16], c[17], c[18], c[19], sum, hops);
        System.arraycopy(sum, 0, to, HISTORY, hops);
    }

    private static void first(float[] x, float c0, float c1, float c2, float c3, float c4, float[] to, int hops) {
        for (int b = 0; b < hops; b++) {
            to[b] = c0 * x[b]
                    + c1 * x[STRIDE + b]
                    + c2 * x[2 * STRIDE + b]
                    + c3 * x[3 * STRIDE + b]
                    + c4 * x[4 * STRIDE + b];
        }
    }

    private static void add(float[] x, int at, float c0, float c1, float c2, float c3, float c4, float[] to, int hops) {
        for (int b = 0; b < hops; b++) {
            to[b] += c0 * x[at + b]
                    + c1 * x[at + STRIDE + b]
                    + c2 * x[at + 2 * STRIDE + b]
                    + c3 * x[at + 3 * STRIDE + b]
                    + c4 * x[at + 4 * STRIDE + b];
        }
    }
}
