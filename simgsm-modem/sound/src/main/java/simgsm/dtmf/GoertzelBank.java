package simgsm.dtmf;

import java.util.Arrays;

/**
 * Eight Goertzel filters over blocks of {@link #HOP} samples. Both last states of each filter are kept for {@link
 * #HISTORY} blocks; they give the block's complex sum, and the sums of several blocks give a {@link Window}. A sine of
 * peak A at a tone has the value A times {@link #gain}.
 *
 * <p>The filters hear x[n] - x[n-2], which has no direct current and little mains hum.
 */
final class GoertzelBank {
    static final int HOP = 20;
    static final int HOPS_PER_SECOND = 400;
    static final int HISTORY = 64;
    static final int TONES = 8;
    private static final int WITH_TWO_BEFORE = HOP + 2;
    /** The first tone of the high group. */
    static final int GROUP = 4;

    static final int[] HERTZ = {697, 770, 852, 941, 1209, 1336, 1477, 1633};

    private static final double[] COEFFICIENT = new double[TONES];

    static {
        for (int k = 0; k < TONES; k++) {
            COEFFICIENT[k] = 2 * Math.cos(radians(HERTZ[k]));
        }
    }

    /** {@code [tone][block]}: s[n] and s[n-1] of the recursion s[n] = x[n] + 2 cos(w) s[n-1] - s[n-2]. */
    private final double[][] newer = new double[TONES][HISTORY];

    private final double[][] older = new double[TONES][HISTORY];
    /** {@code [22 block]}: each block, after the two samples before it. */
    private final short[] recent = new short[WITH_TWO_BEFORE * HISTORY];
    /** The hop whose columns each block has; they are filtered when they are first measured: sound without a row needs none. */
    private final long[] columnsOf = new long[HISTORY];

    /** The sum measured last. */
    double real;

    double imaginary;
    private long hops;

    /** A weighted sum of blocks, the newest first, with the phase of the tone in their middle. */
    static final class Window {
        /** {@code [tone][4 block]}: factors of both states in the real and in the imaginary part. */
        private final double[][] factors;

        Window(double... weights) {
            int blocks = weights.length;
            factors = new double[TONES][4 * blocks];
            for (int k = 0; k < TONES; k++) {
                double step = radians(HERTZ[k]);
                for (int j = 0; j < blocks; j++) {
                    double later = ((blocks - 1) / 2.0 - j) * HOP + (HOP - 1) / 2.0;
                    factors[k][4 * j] = weights[j] * Math.cos(later * step) / 10;
                    factors[k][4 * j + 1] = weights[j] * Math.cos((later + 1) * step) / 10;
                    factors[k][4 * j + 2] = weights[j] * Math.sin(later * step) / 10;
                    factors[k][4 * j + 3] = weights[j] * Math.sin((later + 1) * step) / 10;
                }
            }
        }
    }

    GoertzelBank() {
        reset();
    }

    private static double radians(double hertz) {
        return 2 * Math.PI * hertz / 8000;
    }

    /** Adds the block {@code samples[at..at + 20)}; the two samples before are required, too. */
    void accept(short[] samples, int at) {
        int slot = (int) (hops & HISTORY - 1);
        System.arraycopy(samples, at - 2, recent, WITH_TWO_BEFORE * slot, WITH_TWO_BEFORE);
        filterFour(0, slot);
        hops++;
    }

    /** Goertzel's recursion for one group, its four chains side by side, two samples a step. */
    private void filterFour(int k, int slot) {
        double ca = COEFFICIENT[k];
        double cb = COEFFICIENT[k + 1];
        double cc = COEFFICIENT[k + 2];
        double cd = COEFFICIENT[k + 3];
        double a1 = 0;
        double a2 = 0;
        double b1 = 0;
        double b2 = 0;
        double c1 = 0;
        double c2 = 0;
        double d1 = 0;
        double d2 = 0;
        int from = WITH_TWO_BEFORE * slot;
        for (int i = from; i < from + HOP; i += 2) {
            double x = recent[i + 2] - recent[i];
            double y = recent[i + 3] - recent[i + 1];
            a2 = x - a2 + ca * a1;
            b2 = x - b2 + cb * b1;
            c2 = x - c2 + cc * c1;
            d2 = x - d2 + cd * d1;
            a1 = y - a1 + ca * a2;
            b1 = y - b1 + cb * b2;
            c1 = y - c1 + cc * c2;
            d1 = y - d1 + cd * d2;
        }
        put(k, slot, a1, a2);
        put(k + 1, slot, b1, b2);
        put(k + 2, slot, c1, c2);
        put(k + 3, slot, d1, d2);
    }

    private void put(int k, int slot, double s1, double s2) {
        newer[k][slot] = s1;
        older[k][slot] = s2;
    }

    /** Blocks accepted since the last reset. */
    long hops() {
        return hops;
    }

    /** Sums a tone's blocks up to one. @return square of the amplitude times the gain */
    double measure(int tone, long hop, Window window) {
        double[] f = window.factors[tone];
        if (tone >= GROUP) {
            filterColumns(hop, f.length / 4);
        }
        double[] s1 = newer[tone];
        double[] s2 = older[tone];
        double x = 0;
        double y = 0;
        for (int j = 0, i = 0; i < f.length; j++, i += 4) {
            int slot = (int) hop - j & HISTORY - 1;
            x += s1[slot] * f[i] - s2[slot] * f[i + 1];
            y += s2[slot] * f[i + 3] - s1[slot] * f[i + 2];
        }
        real = x;
        imaginary = y;
        return x * x + y * y;
    }

    private void filterColumns(long hop, int blocks) {
        for (long each = hop; each > hop - blocks; each--) {
            int slot = (int) (each & HISTORY - 1);
            if (columnsOf[slot] != each) {
                filterFour(GROUP, slot);
                columnsOf[slot] = each;
            }
        }
    }

    void reset() {
        Arrays.fill(recent, (short) 0);
        Arrays.fill(columnsOf, -1);
        for (int k = 0; k < TONES; k++) {
            Arrays.fill(newer[k], 0);
            Arrays.fill(older[k], 0);
        }
        hops = 0;
    }

    /** Gain of the difference x[n] - x[n-2] at a frequency. */
    static double gain(double hertz) {
        return 2 * Math.sin(radians(hertz));
    }

    /** Gain of one block for a sine at a distance from its tone. */
    static double leak(double hertz) {
        double x = radians(hertz) / 2;
        return x == 0 ? 1 : Math.sin(HOP * x) / (HOP * Math.sin(x));
    }
}
