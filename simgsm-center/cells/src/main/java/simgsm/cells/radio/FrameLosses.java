package simgsm.cells.radio;

import java.util.function.DoubleSupplier;

/**
 * The lost speech frames of one direction of a call, in bursts as long as the fades of a Rayleigh channel at the
 * mobile's speed: a chain of two states, lost and received (Gilbert), with a given share of lost frames.
 */
public final class FrameLosses {
    private static final double FRAME_SECONDS = 0.02;
    private static final double LIGHT_METRES_PER_SECOND = 299_792_458;
    /** Effective speed of a mobile at rest among people and cars: 3 km/h, the slowest profile of TS 45.005 (TU3). */
    private static final double LEAST_METRES_PER_SECOND = 3 / 3.6;

    private final DoubleSupplier random;
    private boolean isLost;

    /** @param random from 0 to less than 1 */
    public FrameLosses(DoubleSupplier random) {
        this.random = random;
    }

    /**
     * True if the next frame is lost.
     *
     * @param share of lost frames in the long run, 0 to 1; without losses no number is drawn
     */
    public boolean next(double share, double metresPerSecond, double megahertz) {
        if (share <= 0 || share >= 1) {
            isLost = share >= 1;
        } else {
            double burst = burstFrames(share, dopplerHertz(metresPerSecond, megahertz));
            double lossRate = isLost ? 1 - 1 / burst : share / (1 - share) / burst;
            isLost = random.getAsDouble() < lossRate;
        }
        return isLost;
    }

    static double dopplerHertz(double metresPerSecond, double megahertz) {
        return Math.max(metresPerSecond, LEAST_METRES_PER_SECOND) * megahertz * 1e6 / LIGHT_METRES_PER_SECOND;
    }

    /** Mean number of successive lost frames: the length of a fade, but at least that of independent losses. */
    static double burstFrames(double share, double dopplerHertz) {
        return Math.max(1 / (1 - share), fadeSeconds(share, dopplerHertz) / FRAME_SECONDS);
    }

    /**
     * The average duration of fades below the level that a Rayleigh channel is below for this share of the time:
     * (exp(r^2) - 1) / (r f sqrt(2 pi)) at r = sqrt(-ln(1 - share)) of the effective level (Jakes).
     */
    static double fadeSeconds(double share, double dopplerHertz) {
        double ratio = Math.sqrt(-Math.log1p(-share));
        return Math.expm1(ratio * ratio) / (ratio * dopplerHertz * Math.sqrt(2 * Math.PI));
    }
}
