package simrobot.control;

/**
 * An event in the log.
 *
 * @param timeNanos simulated time
 * @param robot the robot's name
 */
public record LoggedEvent(long timeNanos, String robot, RobotEvent event) {}
