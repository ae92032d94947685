package simrobot.robot;

import vericommand.Pose;

/**
 * What a robot's controller knows of itself, at one instant; immutable.
 *
 * @param stalled its wheels are held by what it has run into
 * @param odometry where the wheels say that it is
 */
public record Condition(double batteryVolts, boolean batteryLow, boolean stalled, Bumpers bumpers, Pose odometry) {}
