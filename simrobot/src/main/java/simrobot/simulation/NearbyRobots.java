package simrobot.simulation;

import java.util.Arrays;
import simrobot.robot.SimulatedRobot;

/** The robots within reach of another one's sensors now, or possibly before the next lookup. */
final class NearbyRobots {
    private SimulatedRobot[] robots = {};
    private int count;
    private long step = Long.MIN_VALUE / 2;
    private long epoch = -1;

    /** True if the list is of this epoch and at most this number of steps old. */
    boolean isValid(long now, long mostSteps, long presentEpoch) {
        return epoch == presentEpoch && now - step <= mostSteps;
    }

    /** Empties the list. */
    void clear(long now, long presentEpoch) {
        count = 0;
        step = now;
        epoch = presentEpoch;
    }

    void add(SimulatedRobot robot) {
        if (count == robots.length) {
            robots = Arrays.copyOf(robots, Math.max(4, 2 * count));
        }
        robots[count++] = robot;
    }

    int count() {
        return count;
    }

    SimulatedRobot get(int index) {
        return robots[index];
    }
}
