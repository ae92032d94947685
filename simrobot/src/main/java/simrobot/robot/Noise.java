package simrobot.robot;

import java.util.SplittableRandom;

/**
 * What real wheels and sonars get wrong. The wheels' tyres differ from their nominal size by a share that is drawn once and
 * slip by another that is drawn anew at each step; sonars scatter. All of it comes from a seed: wheels draw in the order of
 * steps, sonars by the step's number, so that looking at them changes nothing.
 *
 * <p>Scale 1 is what MobileSim has: at most 0.75 % of the way and of the turn. Scale 0 is exact.
 */
public final class Noise {
    public static final Noise NONE = new Noise(0, 0);

    /** Ten times what MobileSim has. */
    public static final double MOST = 10;

    private static final double WHEEL_SHARE = 0.0075;

    /** At most so much of a range ... */
    private static final double SONAR_SHARE = 0.005;

    /** ... and so much more. */
    private static final double SONAR_METERS = 0.005;

    private final double scale;
    private final long seed;
    private final SplittableRandom wheels;
    private final double tyres;
    private final double track;

    /** @param scale 0 for none, 1 as MobileSim, at most 10 */
    public Noise(double scale, long seed) {
        if (!(scale >= 0 && scale <= MOST)) {
            throw new IllegalArgumentException("noise " + scale + ", expected 0 to " + MOST);
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

    /** What a metre of the wheels is in truth, in this step. */
    double way() {
        return scale == 0 ? 1 : 1 + tyres + share();
    }

    /** What a radian of the wheels is in truth, in this step. */
    double turn() {
        return scale == 0 ? 1 : 1 + track + share();
    }

    /** What a sonar makes of a range; no echo stays none. */
    double sonar(double meters, int sonar, long step) {
        if (scale == 0 || meters >= Pioneer2Dx.SONAR_RANGE_METERS) {
            return meters;
        }
        double drawn = new SplittableRandom(seed ^ (step * SonarRing.COUNT + sonar)).nextDouble(-1, 1);
        double heard = meters + drawn * scale * (SONAR_METERS + SONAR_SHARE * meters);
        return Math.max(Pioneer2Dx.SONAR_LEAST_METERS, Math.min(Pioneer2Dx.SONAR_RANGE_METERS, heard));
    }
}
