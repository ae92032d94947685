package simgsm.cells.radio;

import java.util.SplittableRandom;

/**
 * Log-normal shadowing as a field over the ground: a normal distribution in dB, whose correlation falls with distance as
 * exp(-d / D) (M. Gudmundson, Electronics Letters 27, 1991). The same seed gives the same field, so a mobile that comes back
 * finds the same level.
 *
 * <p>The field is a sum of {@value #WAVES} waves of random direction and phase. Their wave numbers k have the distribution
 * whose plane transform is the exponential: P(k &lt; K) = 1 - 1 / sqrt(1 + (K D)^2).
 */
public final class ShadowField {
    private static final int WAVES = 48;
    /** One period of the cosine in a table; a step is 0.09 degrees. */
    private static final int TABLE = 4096;

    private static final float[] COSINE = cosine();
    /** Minimum wavelength of 1 m: positions are not known more exactly. */
    private static final double WAVE_NUMBER_MAX = 2 * Math.PI;

    private final float amplitudeDecibels;
    private final double[] stepsPerMeterEast = new double[WAVES];
    private final double[] stepsPerMeterNorth = new double[WAVES];
    private final double[] phaseSteps = new double[WAVES];

    /**
     * @param deviationDecibels standard deviation
     * @param correlationMetres D
     */
    public ShadowField(double deviationDecibels, double correlationMetres, long seed) {
        amplitudeDecibels = (float) (deviationDecibels * Math.sqrt(2.0 / WAVES));
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < WAVES; i++) {
            // strata instead of independent draws: each field has the whole range of waves
            double rest = 1 - (i + random.nextDouble()) / WAVES;
            double waveNumber = Math.min(WAVE_NUMBER_MAX, Math.sqrt(1 / (rest * rest) - 1) / correlationMetres);
            double direction = random.nextDouble(2 * Math.PI);
            double steps = waveNumber * TABLE / (2 * Math.PI);
            stepsPerMeterEast[i] = steps * Math.cos(direction);
            stepsPerMeterNorth[i] = steps * Math.sin(direction);
            phaseSteps[i] = random.nextDouble(TABLE);
        }
    }

    private static float[] cosine() {
        float[] table = new float[TABLE];
        for (int i = 0; i < TABLE; i++) {
            table[i] = (float) Math.cos(2 * Math.PI * i / TABLE);
        }
        return table;
    }

    /** The additional loss at a place in dB; its mean over all places is 0. */
    public double decibels(double xMetres, double yMetres) {
        if (amplitudeDecibels == 0) {
            return 0;
        }
        float sum = 0;
        for (int i = 0; i < WAVES; i++) {
            double steps = stepsPerMeterEast[i] * xMetres + stepsPerMeterNorth[i] * yMetres + phaseSteps[i];
            sum += COSINE[(int) (long) steps & TABLE - 1];
        }
        return sum * amplitudeDecibels;
    }
}
