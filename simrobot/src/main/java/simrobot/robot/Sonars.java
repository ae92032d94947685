package simrobot.robot;

import java.util.Arrays;
import simrobot.world.Cone;

/**
 * The sonars of one robot. Each array of eight fires one sonar every 40 ms, both arrays at the same time, so that a
 * range is up to 320 ms old (P2OS manual; in the order of ARIA's numbers). All ranges are renewed when something on the
 * floor is placed by hand, and when this robot comes to rest.
 *
 * <p>A range is computed when it is read, from all positions at the firing: unread sonars cost nothing, and reading
 * changes nothing.
 */
public final class Sonars {
    private static final int EACH_ARRAY = SonarRing.COUNT / 2;
    private static final double HALF_CONE_RADIANS = Pioneer2Dx.SONAR_CONE_RADIANS / 2;

    /**
     * Distance of a mouth from the robot's centre below which no wall can be in front of it: walls stay out of the
     * collision circle, and other robots' bodies reach at most 0.04 m into it.
     */
    private static final double FREE_ARM_METERS = Pioneer2Dx.RADIUS_METERS - 0.04;

    /** One sonar in the robot's frame: mouth, its distance from the centre, and the two rays that bound its cone. */
    private record Mount(double x, double y, double arm, double leftX, double leftY, double rightX, double rightY) {
        static Mount of(int sonar) {
            double x = SonarRing.mountX(sonar);
            double y = SonarRing.mountY(sonar);
            double left = SonarRing.directionRadians(sonar) + HALF_CONE_RADIANS;
            double right = SonarRing.directionRadians(sonar) - HALF_CONE_RADIANS;
            return new Mount(
                    x,
                    y,
                    Math.sqrt(x * x + y * y),
                    StrictMath.cos(left),
                    StrictMath.sin(left),
                    StrictMath.cos(right),
                    StrictMath.sin(right));
        }
    }

    private static final Mount[] MOUNTS = new Mount[SonarRing.COUNT];

    static {
        for (int i = 0; i < MOUNTS.length; i++) {
            MOUNTS[i] = Mount.of(i);
        }
    }

    private final SimulatedRobot robot;
    private final Floor floor;
    private final SonarClock clock;
    private final Rotation direction = new Rotation();

    /** The robot's positions by {@link SonarClock}'s moments. */
    private final double[] xs = new double[SonarClock.MOMENTS];

    private final double[] ys = new double[SonarClock.MOMENTS];
    private final double[] headings = new double[SonarClock.MOMENTS];

    private final double[] ranges = new double[SonarRing.COUNT];

    /** The firing of each range: a step, or a renewal as a negative number; the least for none. */
    private final long[] firings = new long[SonarRing.COUNT];

    private boolean rests;
    /** The step in which the robot has come to rest; all ranges are of that step or later. */
    private long restStep = -1;

    Sonars(SimulatedRobot robot, Floor floor) {
        this.robot = robot;
        this.floor = floor;
        clock = floor.sonarClock();
        Arrays.fill(firings, Long.MIN_VALUE);
    }

    // ---- time ----------------------------------------------------------------------------------------------------

    /** Stores the robot's position. */
    void keep(int moment) {
        xs[moment] = robot.xMeters();
        ys[moment] = robot.yMeters();
        headings[moment] = robot.headingRadians();
    }

    /** Handles the robot's coming to rest: at the end of the step all sonars measure, read or not. */
    void rest() {
        if (!rests) {
            rests = true;
            clock.addResting(this);
        }
    }

    /** Measures after all robots have moved through the step in which this one came to rest. */
    void measureAtRest() {
        rests = false;
        restStep = clock.steps();
        for (int sonar = 0; sonar < SonarRing.COUNT; sonar++) {
            ranges[sonar] = noisyRangeMeters(sonar, restStep, SonarClock.NOW);
            firings[sonar] = restStep;
        }
    }

    /** The robot's position now or at a moment of the clock. */
    public double xMeters(int moment) {
        return moment == SonarClock.NOW ? robot.xMeters() : xs[moment];
    }

    /** As {@link #xMeters}. */
    public double yMeters(int moment) {
        return moment == SonarClock.NOW ? robot.yMeters() : ys[moment];
    }

    /** As {@link #xMeters}; not wrapped. */
    public double headingRadians(int moment) {
        return moment == SonarClock.NOW ? robot.headingRadians() : headings[moment];
    }

    // ---- ranges --------------------------------------------------------------------------------------------------

    /** One sonar's latest range, 0.1 to 5 m, with noise. */
    double rangeMeters(int sonar) {
        long fired = clock.lastStepOf(sonar % EACH_ARRAY);
        long renewed = clock.renewedStep();
        if (restStep > renewed && restStep >= fired) {
            return ranges[sonar];
        }
        if (fired > renewed) {
            return rangeMeters(sonar, fired, fired, clock.moment(fired));
        }
        return clock.isRenewedNow()
                ? noisyRangeMeters(sonar, renewed, SonarClock.NOW)
                : rangeMeters(sonar, -clock.renewals(), renewed, SonarClock.RENEWED);
    }

    private double rangeMeters(int sonar, long firing, long step, int moment) {
        if (firings[sonar] != firing) {
            ranges[sonar] = noisyRangeMeters(sonar, step, moment);
            firings[sonar] = firing;
        }
        return ranges[sonar];
    }

    private double noisyRangeMeters(int sonar, long step, int moment) {
        return robot.noise().sonar(exactRangeMeters(sonar, moment), sonar, step);
    }

    /**
     * The exact range at a moment. The rear mouths are outside the collision circle, so a wall may be between the
     * robot's centre and a mouth; such a sonar measures the minimum range.
     */
    private double exactRangeMeters(int sonar, int moment) {
        Mount mount = MOUNTS[sonar];
        double x = xMeters(moment);
        double y = yMeters(moment);
        direction.to(headingRadians(moment));
        double cos = direction.cos();
        double sin = direction.sin();
        double armX = mount.x * cos - mount.y * sin;
        double armY = mount.x * sin + mount.y * cos;
        if (mount.arm > FREE_ARM_METERS
                && floor.rayRange(robot, x, y, armX / mount.arm, armY / mount.arm, mount.arm, moment) < mount.arm) {
            return Pioneer2Dx.SONAR_LEAST_METERS;
        }
        Cone cone = new Cone(
                x + armX,
                y + armY,
                mount.leftX * cos - mount.leftY * sin,
                mount.leftX * sin + mount.leftY * cos,
                mount.rightX * cos - mount.rightY * sin,
                mount.rightX * sin + mount.rightY * cos);
        return Math.max(
                Pioneer2Dx.SONAR_LEAST_METERS, floor.coneRange(robot, cone, Pioneer2Dx.SONAR_RANGE_METERS, moment));
    }
}
