package simrobot.robot;

/**
 * A program's access to a robot's drive, used by P2OS and ROS clients: a motion command ends the robot's process; an
 * order by telephone has priority.
 */
public final class DirectControl {
    private final SimulatedRobot robot;

    public DirectControl(SimulatedRobot robot) {
        this.robot = robot;
    }

    /** Sets the initial limits, those of the configuration packet. */
    public void begin() {
        robot.drive().setLimits(Drive.AHEAD_LIMITS, Drive.TURN_LIMITS);
        setSuspended(false);
    }

    /** Takes the drive for a motion command. @return false without motors, and while the robot executes an order */
    public boolean take() {
        boolean isFree = robot.hasMotors() && !robot.isUnderOrder();
        if (isFree) {
            robot.autonomy().end();
        }
        return isFree;
    }

    /** See {@link Drive#setSuspended}; without effect on a process. */
    public void setSuspended(boolean suspend) {
        robot.drive().setSuspended(suspend && !robot.isAutonomous());
    }

    /** Brakes the program's motion. */
    public void end() {
        if (!robot.isUnderOrder() && !robot.isAutonomous()) {
            robot.drive().stop();
        }
    }
}
