package simgsm.speech;

import java.util.Arrays;

/**
 * Changes the sample rate by a windowed-sinc filter, one set of taps for each phase between the two rates. Streaming:
 * write input samples, read output samples. Output sample n is at the time of input sample n * inRate / outRate.
 */
public final class Resampler {
    /** The transition band of the filter, set by a Kaiser window. */
    public enum Slope {
        /** For listening: passes 0 to 90 % of the lower Nyquist frequency, attenuates aliases by 80 dB above 110 %. */
        STEEP(25, 8),
        /** For DTMF, with a fifth of the look-ahead: passes 0 to 75 %, attenuates aliases by 40 dB above 125 %. */
        GENTLE(5, 3.4);

        /** Half the taps, in samples of the lower rate. */
        private final double halfWidth;

        private final double kaiserBeta;

        Slope(double halfWidth, double kaiserBeta) {
            this.halfWidth = halfWidth;
            this.kaiserBeta = kaiserBeta;
        }
    }

    /** Rates with more phases than this use the nearest one, an error of 1/4096 of a sample. */
    private static final int MOST_PHASES = 2048;

    private final int inRate;
    private final long inStep;
    private final long outStep;
    private final int half;
    private final float[][] taps;
    private float[] waiting;
    /** Stream position, in samples, of {@code waiting[0]}. */
    private long waitingFrom;

    private int waitingCount;
    private long written;
    private long read;

    /** @param inRate Hz; @param outRate Hz */
    public Resampler(int inRate, int outRate, Slope slope) {
        this.inRate = inRate;
        long divisor = gcd(inRate, outRate);
        inStep = inRate / divisor;
        outStep = outRate / divisor;
        double lowerShare = Math.min(inRate, outRate) / (double) inRate;
        half = (int) Math.ceil(slope.halfWidth / lowerShare);
        taps = new float[(int) Math.min(outStep, MOST_PHASES)][];
        for (int phase = 0; phase < taps.length; phase++) {
            taps[phase] = taps(phase / (double) taps.length, lowerShare, slope.kaiserBeta);
        }
        waiting = new float[2 * half + 4096];
        waitingFrom = -half;
        waitingCount = half;
    }

    private static long gcd(long a, long b) {
        return b == 0 ? a : gcd(b, a % b);
    }

    /** Taps for the samples {@code -half+1 .. half} around a point {@code fraction} of a sample after sample 0. */
    private float[] taps(double fraction, double lowerShare, double kaiserBeta) {
        float[] result = new float[2 * half];
        double[] exact = new double[2 * half];
        double sum = 0;
        for (int i = 0; i < exact.length; i++) {
            double distance = i - (half - 1) - fraction;
            double x = Math.PI * lowerShare * distance;
            double u = distance / half;
            double window = Math.abs(u) >= 1 ? 0 : bessel(kaiserBeta * Math.sqrt(1 - u * u)) / bessel(kaiserBeta);
            exact[i] = (x == 0 ? 1 : Math.sin(x) / x) * window;
            sum += exact[i];
        }
        for (int i = 0; i < exact.length; i++) {
            result[i] = (float) (exact[i] / sum);
        }
        return result;
    }

    /** The modified Bessel function of order 0, by its series. */
    private static double bessel(double x) {
        double term = 1;
        double sum = 1;
        for (int k = 1; term > 1e-12 * sum; k++) {
            term *= x / (2 * k) * (x / (2 * k));
            sum += term;
        }
        return sum;
    }

    /** Time from an output sample to the last input sample needed. */
    public double lookAheadSeconds() {
        return half / (double) inRate;
    }

    /** Adds input samples. */
    public void write(float[] samples, int count) {
        reserve(count);
        System.arraycopy(samples, 0, waiting, waitingCount, count);
        waitingCount += count;
        written += count;
    }

    /** Ends the input; the rest of the output can then be read. */
    public void end() {
        reserve(half);
        Arrays.fill(waiting, waitingCount, waitingCount + half, 0);
        waitingCount += half;
    }

    private void reserve(int count) {
        long needed = read * inStep / outStep - half + 1;
        int done = (int) Math.max(0, Math.min(waitingCount, needed - waitingFrom));
        if (waitingCount - done + count > waiting.length) {
            waiting = Arrays.copyOf(waiting, waitingCount - done + count + 4096);
        }
        System.arraycopy(waiting, done, waiting, 0, waitingCount - done);
        waitingFrom += done;
        waitingCount -= done;
    }

    /** Writes the available output to {@code samples[from..to)}. @return the number of samples */
    public int read(short[] samples, int from, int to) {
        int at = from;
        for (; at < to; at++, read++) {
            long position = read * inStep / outStep;
            int first = (int) (position - half + 1 - waitingFrom);
            if (first + 2 * half > waitingCount || position >= written) {
                break;
            }
            long phase = read * inStep % outStep;
            float[] filter = taps[(int) (outStep <= MOST_PHASES ? phase : phase * MOST_PHASES / outStep)];
            float sum = 0;
            for (int i = 0; i < filter.length; i++) {
                sum += filter[i] * waiting[first + i];
            }
            samples[at] = saturate(sum);
        }
        return at - from;
    }

    /** Rounded and limited to 16 bits. */
    public static short saturate(float value) {
        return (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, Math.round(value)));
    }
}
