package simgsm.tone;

/**
 * A sine by rotation of a phasor. In double precision its amplitude drifts by less than 1e-12 in a minute, so the
 * only noise is the rounding to 16 bits.
 */
public final class Sine {
    private static final double SAMPLES_PER_SECOND = 8000;

    private final double stepCosine;
    private final double stepSine;
    private double cosine;
    private double sine;

    /** Starts at phase 0; the amplitude is the peak. */
    public Sine(double hertz, double amplitude) {
        double step = 2 * Math.PI * hertz / SAMPLES_PER_SECOND;
        stepCosine = Math.cos(step);
        stepSine = Math.sin(step);
        cosine = amplitude;
    }

    /** The next sample, -amplitude to amplitude. */
    public double next() {
        double value = sine;
        sine = value * stepCosine + cosine * stepSine;
        cosine = cosine * stepCosine - value * stepSine;
        return value;
    }
}
