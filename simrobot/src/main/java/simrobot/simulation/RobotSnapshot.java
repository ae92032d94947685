package simrobot.simulation;

import simrobot.behaviour.BehaviourKind;
import simrobot.robot.Condition;
import simrobot.robot.Trail;
import vericommand.RobotStatus;

/**
 * One robot at one instant; immutable.
 *
 * @param headingRadians anticlockwise from +X, not wrapped
 * @param turnRadiansPerSecond anticlockwise
 * @param sonarRangesMeters sixteen, sonar 0 first; empty when nobody watches this robot
 * @param simulated false of a real robot, which SimRobot only drives; its camera is its own
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
        Condition condition,
        Trail.Points trail,
        BehaviourKind behaviour,
        boolean simulated) {}
