package vericommand;

import java.util.function.Consumer;

/** The port through which orders reach a robot, simulated or real. Everything happens on the robot's owner thread. */
public interface Robot {
    RobotStatus status();

    /**
     * Starts a motion; the status is Moving from here on. A motion may end before this returns.
     *
     * @param ended told exactly once how the motion ended, on the owner thread, after the status has changed
     * @throws IllegalStateException unless {@link StatusRules} says that the motion is executed in the present status
     */
    void start(Instruction.Motion motion, Consumer<MotionOutcome> ended);

    /** Brakes with the robot's deceleration; the motion under way ends when the robot stands. Standing: no effect. */
    void brake();

    /** Whether a process of its own moves it; the status is Moving then, unless it has just touched something. */
    default boolean isAutonomous() {
        return false;
    }

    /**
     * Ends that process; the robot slows down to a stand.
     *
     * @param stands told exactly once, on the owner thread, when the robot stands; perhaps before this returns
     */
    default void endAutonomy(Runnable stands) {
        stands.run();
    }

    /** The true pose. */
    Pose pose();
}
