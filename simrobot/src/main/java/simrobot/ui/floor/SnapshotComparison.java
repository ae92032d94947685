package simrobot.ui.floor;

import java.util.Arrays;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Surface;

/** Finds out whether two snapshots look the same but for the clock, so that a floor at rest is not painted again. */
public final class SnapshotComparison {
    /** Trails fade; at rest they are painted again every 10 s of simulated time. */
    private static final long FADE_NANOS = 10_000_000_000L;

    private SnapshotComparison() {}

    public static boolean looksTheSame(SimulationSnapshot before, SimulationSnapshot now) {
        return before.world() == now.world()
                && before.behaviours().equals(now.behaviours())
                && before.behaviourFaults().equals(now.behaviourFaults())
                && now.world().surfaces().stream().noneMatch(Surface::isMoving)
                && (!hasTrails(now) || before.timeNanos() / FADE_NANOS == now.timeNanos() / FADE_NANOS)
                && now.hasRobotsAs(before, SnapshotComparison::looksTheSame);
    }

    private static boolean hasTrails(SimulationSnapshot now) {
        return now.robots().stream().anyMatch(robot -> robot.trail().size() > 1);
    }

    private static boolean looksTheSame(RobotSnapshot a, RobotSnapshot b) {
        return a.name().equals(b.name())
                && a.status() == b.status()
                && a.motors() == b.motors()
                && a.isAtPoseOf(b)
                && a.behaviour() == b.behaviour()
                && a.trail() == b.trail()
                && a.marks() == b.marks()
                && Arrays.equals(a.sonarRangesMeters(), b.sonarRangesMeters())
                && Arrays.equals(a.laserRangesMeters(), b.laserRangesMeters());
    }
}
