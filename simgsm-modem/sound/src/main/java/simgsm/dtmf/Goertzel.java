package simgsm.dtmf;

/**
 * Energy of one frequency in a run of samples, by Goertzel's recursion
 * <pre>
 *   s[n] = x[n] + 2 cos(w) s[n-1] - s[n-2]      |X(w)|^2 = s1^2 + s2^2 - 2 cos(w) s1 s2
 * </pre>
 * equal to the direct sum |sum of x[n] e^(-jwn)|^2 over all samples accepted since the last reset. A sine of peak A
 * over N samples gives (A N / 2)^2.
 */
public final class Goertzel {
    private static final double SAMPLES_PER_SECOND = 8000;

    private final double coefficient;
    private double s1;
    private double s2;
    private int count;

    public Goertzel(double hertz) {
        coefficient = 2 * Math.cos(2 * Math.PI * hertz / SAMPLES_PER_SECOND);
    }

    public void accept(short[] samples, int from, int to) {
        for (int i = from; i < to; i++) {
            double s0 = samples[i] + coefficient * s1 - s2;
            s2 = s1;
            s1 = s0;
        }
        count += to - from;
    }

    /** |X|^2 of the accepted samples. */
    public double energy() {
        return s1 * s1 + s2 * s2 - coefficient * s1 * s2;
    }

    /** Peak of a sine with this energy, in sample units; 0 before any sample. */
    public double amplitude() {
        return count == 0 ? 0 : 2 * Math.sqrt(Math.max(0, energy())) / count;
    }

    public void reset() {
        s1 = 0;
        s2 = 0;
        count = 0;
    }
}
