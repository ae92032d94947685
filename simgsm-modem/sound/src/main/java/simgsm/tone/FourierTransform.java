package simgsm.tone;

/** A fast Fourier transform of {@value #SIZE} complex values (Cooley and Tukey, radix 2). Any thread may use it. */
public final class FourierTransform {
    public static final int SIZE = 256;

    private static final double[] COSINE = new double[SIZE / 2];
    private static final double[] SINE = new double[SIZE / 2];

    static {
        for (int i = 0; i < SIZE / 2; i++) {
            COSINE[i] = Math.cos(2 * Math.PI * i / SIZE);
            SINE[i] = -Math.sin(2 * Math.PI * i / SIZE);
        }
    }

    private FourierTransform() {}

    /** The index at which {@link #transform} expects value i: its 8 bits in reverse order. */
    public static int reversed(int i) {
        return Integer.reverse(i) >>> 24;
    }

    /** In place, with input in bit-reversed order. */
    public static void transform(double[] re, double[] im) {
        for (int half = 1; half < SIZE; half *= 2) {
            int stride = SIZE / 2 / half;
            for (int i = 0, t = 0; i < half; i++, t += stride) {
                double c = COSINE[t];
                double s = SINE[t];
                for (int a = i; a < SIZE; a += 2 * half) {
                    int b = a + half;
                    double u = re[b] * c - im[b] * s;
                    double v = im[b] * c + re[b] * s;
                    re[b] = re[a] - u;
                    im[b] = im[a] - v;
                    re[a] += u;
                    im[a] += v;
                }
            }
        }
    }
}
