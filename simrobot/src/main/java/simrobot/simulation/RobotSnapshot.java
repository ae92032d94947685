package simrobot.simulation;

import java.util.List;
import simrobot.behaviour.BehaviourRequest;
import simrobot.process.BehaviourKind;
import simrobot.robot.Condition;
import simrobot.robot.Trail;
import simrobot.world.Position;
import vericommand.RobotStatus;

/**
 * One robot at one instant; immutable.
 *
 * @param headingRadians anticlockwise from +X, not wrapped
 * @param turnRadiansPerSecond anticlockwise
 * @param sonarRangesMeters sixteen, sonar 0 first; empty with over 16 robots unless this one is watched
 * @param path planned by its process; may be empty
 * @param marks drawn on the floor by its process
 * @param laserRangesMeters 181, from 90 degrees at the right to 90 at the left; empty while the laser is off
 * @param simulated false for a real robot, which has no simulated camera
 */
public record RobotSnapshot(
        String name,
        RobotStatus status,
        boolean powered,
        boolean motors,
        double xMeters,
        double yMeters,
        double headingRadians,
        double speedMetersPerSecond,
        double turnRadiansPerSecond,
        double[] sonarRangesMeters,
        double[] laserRangesMeters,
        Condition condition,
        Trail.Points trail,
        BehaviourKind behaviour,
        List<Position> path,
        List<BehaviourRequest.Mark> marks,
        boolean simulated) {
    /** True if the other robot has the same pose. */
    public boolean isAtPoseOf(RobotSnapshot other) {
        return xMeters == other.xMeters && yMeters == other.yMeters && headingRadians == other.headingRadians;
    }
}
