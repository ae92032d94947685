package simrobot.robot;

import simrobot.process.BehaviourKind;
import vericommand.RobotStatus;

/**
 * The observable state of a robot at one instant, to the last bit.
 *
 * @param headingRadians anticlockwise from +X, not wrapped
 * @param speedMetersPerSecond of the wheels, ahead
 * @param turnRadiansPerSecond of the wheels, anticlockwise
 * @param odometryXMeters with the next two the pose by odometry
 */
public record RobotState(
        double xMeters,
        double yMeters,
        double headingRadians,
        double speedMetersPerSecond,
        double turnRadiansPerSecond,
        double odometryXMeters,
        double odometryYMeters,
        double odometryHeadingRadians,
        RobotStatus status,
        BehaviourKind behaviour) {
    static RobotState of(SimulatedRobot robot) {
        return new RobotState(
                robot.xMeters(),
                robot.yMeters(),
                robot.headingRadians(),
                robot.speedMetersPerSecond(),
                robot.turnRadiansPerSecond(),
                robot.odometry().xMeters(),
                robot.odometry().yMeters(),
                robot.odometry().headingRadians(),
                robot.status(),
                robot.autonomy().kind());
    }
}
