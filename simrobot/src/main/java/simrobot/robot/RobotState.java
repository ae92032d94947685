package simrobot.robot;

import java.util.Objects;
import simrobot.behaviour.BehaviourKind;
import vericommand.RobotStatus;

/**
 * What can be seen of a robot at one instant, to the last bit.
 *
 * @param headingRadians anticlockwise from +X, not wrapped
 * @param speedMetersPerSecond ahead, of the wheels
 * @param turnRadiansPerSecond anticlockwise, of the wheels
 */
public record RobotState(
        double xMeters,
        double yMeters,
        double headingRadians,
        double speedMetersPerSecond,
        double turnRadiansPerSecond,
        RobotStatus status,
        BehaviourKind behaviour) {
    public RobotState {
        Objects.requireNonNull(status);
        Objects.requireNonNull(behaviour);
    }
}
