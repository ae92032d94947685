package simrobot.simulation;

import java.util.List;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Steering;
import simrobot.behaviour.Wander;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SonarRing;
import simrobot.world.DiscGrid;
import simrobot.world.Home;
import simrobot.world.ObstacleGrid;
import simrobot.world.Position;
import simrobot.world.World;

/**
 * Robots that wander by the rule with which simulators are compared, and nothing else: steps of 100 ms; sixteen sonars of
 * one ray each, which see walls and robots; speeds that take hold at once; a circle that turns about its middle; a way that
 * is blocked is not gone, and leaves the robot stalled. Compare {@link Simulation}, which has the whole physics.
 *
 * <p>In each step all robots listen first, where the step before has left them, and then move one after another.
 */
public final class WanderRun {
    public static final long STEP_NANOS = Behaviour.TICK_NANOS;

    private static final double RADIUS = Pioneer2Dx.RADIUS_METERS;
    private static final double RANGE = Pioneer2Dx.SONAR_RANGE_METERS;
    /** No mouth is farther from the middle. */
    private static final double ARM = 0.26;

    private static final double SECONDS = STEP_NANOS * 1e-9;

    /** x and y of each sonar's mouth, then x and y of its direction, in the robot's own frame. */
    private static final double[] SONARS = sonars();

    private final ObstacleGrid obstacles;
    private final DiscGrid discs = new DiscGrid();
    private final Surroundings surroundings;
    private final Wander[] rules;
    private final Steering[] steerings;
    private final double[] xs;
    private final double[] ys;
    private final double[] headings;
    private final double[] cosines;
    private final double[] sines;
    private final boolean[] stalled;

    /** The newest ranges of all robots, sixteen each. */
    private final double[] ranges;

    private long steps;
    private final double[] heard = new double[SonarRing.COUNT];

    /**
     * So many robots on the world's homes, or near the first where there are too few.
     *
     * @throws IllegalArgumentException when there is no place for so many
     */
    public WanderRun(World world, int robots) {
        obstacles = new ObstacleGrid(world);
        rules = new Wander[robots];
        steerings = new Steering[robots];
        xs = new double[robots];
        ys = new double[robots];
        headings = new double[robots];
        cosines = new double[robots];
        sines = new double[robots];
        stalled = new boolean[robots];
        ranges = new double[robots * SonarRing.COUNT];
        surroundings =
                new Surroundings(obstacles, discs, xs, ys, RANGE + ARM, RADIUS, Wander.METERS_PER_SECOND * SECONDS);
        List<Home> spots = StartPlaces.spots(world, robots);
        for (int i = 0; i < robots; i++) {
            rules[i] = new Wander(i);
            Position place = spots.get(i).position();
            xs[i] = place.xMeters();
            ys[i] = place.yMeters();
            discs.put(i, xs[i], ys[i]);
            turnTo(i, spots.get(i).headingRadians());
        }
    }

    private static double[] sonars() {
        double[] sonars = new double[4 * SonarRing.COUNT];
        for (int i = 0; i < SonarRing.COUNT; i++) {
            sonars[4 * i] = SonarRing.mountX(i);
            sonars[4 * i + 1] = SonarRing.mountY(i);
            sonars[4 * i + 2] = StrictMath.cos(SonarRing.directionRadians(i));
            sonars[4 * i + 3] = StrictMath.sin(SonarRing.directionRadians(i));
        }
        return sonars;
    }

    public int robots() {
        return xs.length;
    }

    public double xMeters(int robot) {
        return xs[robot];
    }

    public double yMeters(int robot) {
        return ys[robot];
    }

    /** Anticlockwise from +X, not wrapped. */
    public double headingRadians(int robot) {
        return headings[robot];
    }

    /** Whether its last move was blocked. */
    public boolean isStalled(int robot) {
        return stalled[robot];
    }

    /** Metres per second ahead in the last step. */
    public double speedMetersPerSecond(int robot) {
        return steps == 0 || stalled[robot] ? 0 : steerings[robot].metersPerSecond();
    }

    /** Anticlockwise, in the last step. */
    public double turnRadiansPerSecond(int robot) {
        return steps == 0 ? 0 : steerings[robot].radiansPerSecond();
    }

    /** What a sonar heard at the beginning of the last step; from the robot's mouth, at most 5 m. */
    public double rangeMeters(int robot, int sonar) {
        return ranges[robot * SonarRing.COUNT + sonar];
    }

    /** Moves everything on by 100 ms. */
    public void step() {
        for (int i = 0; i < xs.length; i++) {
            listen(i);
            steerings[i] = rules[i].decide(heard, false);
        }
        for (int i = 0; i < xs.length; i++) {
            move(i, steerings[i]);
        }
        steps++;
    }

    private void listen(int robot) {
        double x = xs[robot];
        double y = ys[robot];
        double cos = cosines[robot];
        double sin = sines[robot];
        surroundings.look(robot, steps);
        for (int i = 0; i < SonarRing.COUNT; i++) {
            int at = 4 * i;
            double mouthX = x + SONARS[at] * cos - SONARS[at + 1] * sin;
            double mouthY = y + SONARS[at] * sin + SONARS[at + 1] * cos;
            double ux = SONARS[at + 2] * cos - SONARS[at + 3] * sin;
            double uy = SONARS[at + 2] * sin + SONARS[at + 3] * cos;
            heard[i] = surroundings.rayRange(robot, mouthX, mouthY, ux, uy, RADIUS, RANGE);
        }
        System.arraycopy(heard, 0, ranges, robot * SonarRing.COUNT, SonarRing.COUNT);
    }

    private void move(int robot, Steering steering) {
        stalled[robot] = false;
        if (steering.radiansPerSecond() != 0) {
            turnTo(robot, headings[robot] + steering.radiansPerSecond() * SECONDS);
        }
        if (steering.metersPerSecond() != 0) {
            double way = steering.metersPerSecond() * SECONDS;
            go(robot, xs[robot] + way * cosines[robot], ys[robot] + way * sines[robot]);
        }
    }

    private void turnTo(int robot, double heading) {
        headings[robot] = heading;
        cosines[robot] = StrictMath.cos(heading);
        sines[robot] = StrictMath.sin(heading);
    }

    private void go(int robot, double x, double y) {
        if (obstacles.isFree(x, y, RADIUS) && !discs.isCrowded(robot, x, y, 2 * RADIUS)) {
            xs[robot] = x;
            ys[robot] = y;
            discs.put(robot, x, y);
        } else {
            stalled[robot] = true;
        }
    }
}
