package simrobot.robot;

import java.util.ArrayList;
import java.util.List;

/**
 * When the sonars of all robots on a floor fire: in each array one every 40 ms, the eight of an array in turn. Robots remember
 * where they were at the moments of the last eight firings and of the last renewal, after which all ranges are new.
 */
public final class SonarClock {
    /** Between two firings of an array: P2OS manual, and byte 22 of the configuration packet. */
    private static final long FIRING_NANOS = 40_000_000;

    private static final int TURNS = 8;

    /** The moment that is not remembered. */
    public static final int NOW = -1;

    /** The moment of the last renewal; those of firings are below. */
    static final int RENEWED = TURNS;

    static final int MOMENTS = TURNS + 1;

    private final List<Sonars> resting = new ArrayList<>();
    private final long stepsEach;
    private long steps;
    private long renewedStep;
    private long renewals = 1;
    private boolean renewedNow = true;

    /** @param stepNanos of the simulation, a part of 40 ms */
    public SonarClock(long stepNanos) {
        stepsEach = FIRING_NANOS / stepNanos;
    }

    // ---- for the floor ---------------------------------------------------------------------------------------------

    /** Something has been put elsewhere: all ranges are of now. */
    public void renew() {
        renewedStep = steps;
        renewals++;
        renewedNow = true;
    }

    /** A step begins. @param robots that are about to move */
    public void begin(Iterable<SimulatedRobot> robots) {
        if (renewedNow) {
            robots.forEach(robot -> robot.sonars().keep(RENEWED));
            renewedNow = false;
        }
    }

    /** A step has ended. @param robots that have moved */
    public void end(Iterable<SimulatedRobot> robots) {
        steps++;
        if (steps % stepsEach == 0) {
            int moment = moment(steps);
            robots.forEach(robot -> robot.sonars().keep(moment));
        }
        resting.forEach(Sonars::measureAtRest);
        resting.clear();
    }

    /** The steps of which something is remembered. */
    public long rememberedSteps() {
        return (TURNS + 1) * stepsEach;
    }

    // ---- for the sonars
    // ----------------------------------------------------------------------------------------------

    /** Sonars of a robot that has come to rest in this step. */
    void addResting(Sonars sonars) {
        resting.add(sonars);
    }

    /** Steps that have ended. */
    long steps() {
        return steps;
    }

    long renewedStep() {
        return renewedStep;
    }

    long renewals() {
        return renewals;
    }

    /** Whether no robot has moved since the last renewal. */
    boolean isRenewedNow() {
        return renewedNow;
    }

    /** The step at which the sonars with this turn, 0 to 7, fired last; negative for never. */
    long lastStepOf(int turn) {
        long firings = steps / stepsEach;
        return stepsEach * (firings - Math.floorMod(firings - turn, TURNS));
    }

    /** The moment of a firing. */
    int moment(long step) {
        return (int) (step / stepsEach % TURNS);
    }
}
