package simrobot.robot;

import vericommand.Pose;

/**
 * What a robot's controller measures of itself, at one instant; immutable.
 *
 * @param stalled whether an obstacle blocks the wheels
 * @param odometry the pose by odometry
 * @param odometryZero the true pose at which the odometry was set to 0
 */
public record Condition(
        double batteryVolts, boolean batteryLow, boolean stalled, Bumpers bumpers, Pose odometry, Pose odometryZero) {
    /** The pose that the odometry gives in the world's frame. */
    public Pose estimated() {
        double turn = Math.toRadians(odometryZero.headingDegrees());
        return new Pose(
                odometryZero.xMeters() + odometry.xMeters() * Math.cos(turn) - odometry.yMeters() * Math.sin(turn),
                odometryZero.yMeters() + odometry.xMeters() * Math.sin(turn) + odometry.yMeters() * Math.cos(turn),
                odometryZero.headingDegrees() + odometry.headingDegrees());
    }
}
