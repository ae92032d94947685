package simrobot.robot;

import java.util.function.Consumer;
import vericommand.Robot;
import vericommand.RobotStatus;

/**
 * A Pioneer as the rest of the program knows it, simulated ({@link SimulatedRobot}) or real: what can be ordered by
 * telephone, and its switches and senses. Everything happens on the simulation's owner thread.
 */
public interface Pioneer extends Robot {
    String name();

    /** Told the new status at every change, on the owner thread, before a motion's outcome. */
    void addStatusListener(Consumer<RobotStatus> listener);

    /** Told when the wheels first move for a motion, on the owner thread. */
    void addFirstMotionListener(Runnable listener);

    default boolean isPowered() {
        return status() != RobotStatus.DISCONNECTED;
    }

    default boolean hasMotors() {
        return isPowered() && status() != RobotStatus.NO_MOTORS;
    }

    /** Throws the power switch; of a real robot the link's. Off ends a motion at once. */
    void setPower(boolean on);

    /** Throws the motors' switch; without power nothing happens. Off ends a motion at once. */
    void setMotors(boolean on);

    /** Puts the robot there by hand, standing; of a real robot says that somebody has put it there. */
    Placement place(double xMeters, double yMeters, double headingRadians);

    /** What the sixteen sonars hear, 100 to 5000 mm, sonar 0 first. */
    int[] sonarRangesMillimeters();
}
