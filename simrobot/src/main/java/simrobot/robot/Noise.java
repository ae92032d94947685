package simrobot.robot;

import java.util.SplittableRandom;

/**
 * Errors of wheels, sonars and laser. The size error of the tyres is drawn once, their slip at each step, and ranges
 * scatter. All draws depend on a seed: those of the wheels in the order of steps, those of the ranges by the step's
 * number, so that reading a range changes nothing.
 *
 * <p>Scale 1 equals MobileSim's for wheels and sonars: at most 0.75 % of distance and turn. Scale 0 is exact.
 */
public final class Noise {
    public static final Noise NONE = new Noise(0, 0);

    /** Ten times MobileSim's errors. */
    public static final double MAX_SCALE = 10;

    private static final double WHEEL_SHARE = 0.0075;

    /** Maximum relative error of a sonar's range. */
    private static final double SONAR_SHARE = 0.005;

    /** Maximum absolute error of a sonar's range, added to the relative one. */
    private static final double SONAR_METERS = 0.005;

    /** Standard deviation of a laser's range, that of a SICK LMS 200. */
    private static final double LASER_METERS = 0.005;

    /** Separates the laser's draws from those of the sonars. */
    private static final long LASER_SEED = 0x5DEECE66DL;

    private final double scale;
    private final long seed;
    private final SplittableRandom wheels;
    private final double tyres;
    private final double track;

    /** @param scale 0 for none, 1 as in MobileSim, at most 10 */
    public Noise(double scale, long seed) {
        if (!(scale >= 0 && scale <= MAX_SCALE)) {
            throw new IllegalArgumentException("noise " + scale + ", expected 0 to " + MAX_SCALE);
        }
        this.scale = scale;
        this.seed = seed;
        wheels = new SplittableRandom(seed);
        tyres = share();
        track = share();
    }

    private double share() {
        return scale == 0 ? 0 : wheels.nextDouble(-1, 1) * scale * WHEEL_SHARE / 2;
    }

    /** True distance per distance of the wheels, in this step. */
    double distanceFactor() {
        return scale == 0 ? 1 : 1 + tyres + share();
    }

    /** True turn per turn of the wheels, in this step. */
    double turnFactor() {
        return scale == 0 ? 1 : 1 + track + share();
    }

    /** The measured range of a sonar; 5 m remains without an echo. */
    double sonar(double meters, int sonar, long step) {
        if (scale == 0 || meters >= Pioneer2Dx.SONAR_RANGE_METERS) {
            return meters;
        }
        double drawn = new SplittableRandom(seed ^ (step * SonarRing.COUNT + sonar)).nextDouble(-1, 1);
        double measured = meters + drawn * scale * (SONAR_METERS + SONAR_SHARE * meters);
        return Math.max(Pioneer2Dx.SONAR_LEAST_METERS, Math.min(Pioneer2Dx.SONAR_RANGE_METERS, measured));
    }

    /**
     * The measured range of a laser; 32 m remains without an echo.
     *
     * @param milliradians the reading's direction
     */
    double laser(double meters, long milliradians, long step) {
        if (scale == 0 || meters >= Laser.RANGE_METERS) {
            return meters;
        }
        long drawn = (seed ^ LASER_SEED) + (step << 16) + milliradians;
        double error = new SplittableRandom(drawn).nextGaussian() * scale * LASER_METERS;
        return Math.max(0, Math.min(Laser.RANGE_METERS, meters + error));
    }
}
