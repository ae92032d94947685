package simrobot.robot;

import vericommand.Pose;

/**
 * What a robot's controller knows of itself, at one instant; immutable.
 *
 * @param stalled its wheels are held by what it has run into
 * @param odometry where the wheels say that it is
 * @param odometryZero where it truly was when that was set to 0
 */
public record Condition(
        double batteryVolts, boolean batteryLow, boolean stalled, Bumpers bumpers, Pose odometry, Pose odometryZero) {
    /** Where the robot would be if its wheels were right. */
    public Pose believed() {
        double turn = Math.toRadians(odometryZero.headingDegrees());
        return new Pose(
                odometryZero.xMeters() + odometry.xMeters() * Math.cos(turn) - odometry.yMeters() * Math.sin(turn),
                odometryZero.yMeters() + odometry.xMeters() * Math.sin(turn) + odometry.yMeters() * Math.cos(turn),
                odometryZero.headingDegrees() + odometry.headingDegrees());
    }
}
