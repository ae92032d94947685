package simrobot.robot;

import java.util.SortedMap;
import java.util.function.Consumer;
import vericommand.Robot;
import vericommand.RobotStatus;

/**
 * A Pioneer, simulated ({@link SimulatedRobot}) or real: what can be ordered by telephone, its switches and its sensors. Owned
 * by the simulation's thread.
 */
public interface Pioneer extends Robot {
    String name();

    /** Adds a listener for the new status at every change, called on the owner thread before a motion's outcome. */
    void addStatusListener(Consumer<RobotStatus> listener);

    /** Adds a listener called when the wheels first move for a motion, on the owner thread. */
    void addFirstMotionListener(Runnable listener);

    default boolean isPowered() {
        return status() != RobotStatus.DISCONNECTED;
    }

    default boolean hasMotors() {
        return isPowered() && status() != RobotStatus.NO_MOTORS;
    }

    /** Switches the power, or the link to a real robot. Off ends a motion at once. */
    void setPower(boolean on);

    /** Switches the motors; without power, does nothing. Off ends a motion at once. */
    void setMotors(boolean on);

    /** Moves the robot there by hand; of a real robot, records that it has been moved there. */
    Placement place(double xMeters, double yMeters, double headingRadians);

    /** Its autonomous process. */
    Autonomy autonomy();

    @Override
    default SortedMap<Integer, String> processes() {
        return autonomy().processes();
    }

    @Override
    default void startProcess(int number) {
        autonomy().begin(number);
    }

    @Override
    default boolean isAutonomous() {
        return autonomy().isActive();
    }

    @Override
    default void endAutonomy(Runnable stands) {
        autonomy().endFor(stands);
    }

    /** The ranges of the sixteen sonars, 100 to 5000 mm, sonar 0 first. */
    int[] sonarRangesMillimeters();
}
