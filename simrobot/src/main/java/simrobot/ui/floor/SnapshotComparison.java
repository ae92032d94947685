package simrobot.ui.floor;

import java.util.Arrays;
import java.util.List;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Surface;

/** Finds out whether two snapshots look the same but for the clock, so that a floor at rest is not painted again. */
final class SnapshotComparison {
    /** Trails fade; at rest they are painted again every 2 s of simulated time. */
    private static final long FADE_NANOS = 2_000_000_000;

    private SnapshotComparison() {}

    static boolean looksTheSame(SimulationSnapshot before, SimulationSnapshot now) {
        return before.world() == now.world()
                && now.world().surfaces().stream().noneMatch(Surface::isMoving)
                && before.timeNanos() / FADE_NANOS == now.timeNanos() / FADE_NANOS
                && sameRobots(before.robots(), now.robots());
    }

    private static boolean sameRobots(List<RobotSnapshot> before, List<RobotSnapshot> now) {
        if (before.size() != now.size()) {
            return false;
        }
        for (int i = 0; i < now.size(); i++) {
            if (!same(before.get(i), now.get(i))) {
                return false;
            }
        }
        return true;
    }

    private static boolean same(RobotSnapshot a, RobotSnapshot b) {
        return a.name().equals(b.name())
                && a.status() == b.status()
                && a.xMeters() == b.xMeters()
                && a.yMeters() == b.yMeters()
                && a.headingRadians() == b.headingRadians()
                && a.trail() == b.trail()
                && Arrays.equals(a.sonarRangesMeters(), b.sonarRangesMeters());
    }
}
