package simrobot.robot;

import java.util.ArrayList;
import java.util.List;

/**
 * The firing times of the sonars of all robots on a floor: one sonar of each array every 40 ms, the eight of an array
 * in turn. Robots remember their positions at the last eight firings and at the last renewal, after which all ranges
 * are new.
 */
public final class SonarClock {
    /** Period of an array's firings: P2OS manual, and byte 22 of the configuration packet. */
    private static final long FIRING_NANOS = 40_000_000;

    private static final int TURNS = 8;

    /** The current moment, which is not remembered. */
    public static final int NOW = -1;

    /** The moment of the last renewal; the moments of firings are lower. */
    static final int RENEWED = TURNS;

    static final int MOMENTS = TURNS + 1;

    private final List<Sonars> resting = new ArrayList<>();
    private final long stepsEach;
    private long steps;
    private long renewedStep;
    private long renewals = 1;
    private boolean renewedNow = true;

    /** @param stepNanos of the simulation, a divisor of 40 ms */
    public SonarClock(long stepNanos) {
        stepsEach = FIRING_NANOS / stepNanos;
    }

    // ---- for the floor ---------------------------------------------------------------------------------------------

    /** Renews all ranges after something was placed by hand. */
    public void renew() {
        renewedStep = steps;
        renewals++;
        renewedNow = true;
    }

    /**
     * Begins a step.
     *
     * @param robots that are about to move
     */
    public void begin(Iterable<SimulatedRobot> robots) {
        if (renewedNow) {
            robots.forEach(robot -> robot.sonars().keep(RENEWED));
            renewedNow = false;
        }
    }

    /**
     * Ends a step.
     *
     * @param robots that have moved
     */
    public void end(Iterable<SimulatedRobot> robots) {
        steps++;
        if (steps % stepsEach == 0) {
            int moment = moment(steps);
            robots.forEach(robot -> robot.sonars().keep(moment));
        }
        resting.forEach(Sonars::measureAtRest);
        resting.clear();
    }

    /** History length in steps. */
    public long rememberedSteps() {
        return (TURNS + 1) * stepsEach;
    }

    // ---- for the sonars
    // ----------------------------------------------------------------------------------------------

    /** Registers the sonars of a robot that has come to rest in this step. */
    void addResting(Sonars sonars) {
        resting.add(sonars);
    }

    /** Number of ended steps. */
    long steps() {
        return steps;
    }

    long renewedStep() {
        return renewedStep;
    }

    long renewals() {
        return renewals;
    }

    /** True if no robot has moved since the last renewal. */
    boolean isRenewedNow() {
        return renewedNow;
    }

    /** The step at which the sonars with this turn, 0 to 7, fired last; negative if never. */
    long lastStepOf(int turn) {
        long firings = steps / stepsEach;
        return stepsEach * (firings - Math.floorMod(firings - turn, TURNS));
    }

    /** The moment of a firing. */
    int moment(long step) {
        return (int) (step / stepsEach % TURNS);
    }
}
