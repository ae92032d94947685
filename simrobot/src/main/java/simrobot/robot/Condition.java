package simrobot.robot;

import vericommand.Pose;

/**
 * The measurements of a robot's controller at one instant; immutable.
 *
 * @param stalled true if an obstacle blocks the wheels
 * @param odometry the pose by odometry
 * @param odometryZero the true pose at the reset of the odometry
 */
public record Condition(
        double batteryVolts, boolean batteryLow, boolean stalled, Bumpers bumpers, Pose odometry, Pose odometryZero) {
    /** The pose by odometry in the world's frame. */
    public Pose estimated() {
        double turn = Math.toRadians(odometryZero.headingDegrees());
        return new Pose(
                odometryZero.xMeters() + odometry.xMeters() * Math.cos(turn) - odometry.yMeters() * Math.sin(turn),
                odometryZero.yMeters() + odometry.xMeters() * Math.sin(turn) + odometry.yMeters() * Math.cos(turn),
                odometryZero.headingDegrees() + odometry.headingDegrees());
    }
}
