package vericommand;

import java.util.Collections;
import java.util.Optional;
import java.util.SortedMap;
import java.util.function.Consumer;

/** A robot, simulated or real, as commanded by orders. All methods are called on the robot's owner thread. */
public interface Robot {
    RobotStatus status();

    /**
     * Starts a motion and sets the status Moving. The motion may end before this returns.
     *
     * @param ended called once with the outcome, on the owner thread, after the status has changed
     * @throws IllegalStateException unless {@link StatusRules} lets the current status execute the motion
     */
    void start(Instruction.Motion motion, Consumer<MotionOutcome> ended);

    /** Brakes with the robot's deceleration; the motion ends when the robot has stopped. No effect on a stopped robot. */
    void brake();

    /** True if an autonomous behaviour moves the robot; the status is Moving then, or Collision after a contact. */
    default boolean isAutonomous() {
        return false;
    }

    /**
     * Ends the autonomous behaviour; the robot brakes.
     *
     * @param standing runs once, on the owner thread, when the robot has stopped; possibly before this returns
     */
    default void endAutonomy(Runnable standing) {
        standing.run();
    }

    /** The name of an unknown robot type, which keeps the status No motors. Empty for a known type. */
    default Optional<String> unknownType() {
        return Optional.empty();
    }

    /** True if the battery must be charged; each reply says so. */
    default boolean hasLowBattery() {
        return false;
    }

    /** The names of the processes that orders can start, by number, 1..99; none if empty. */
    default SortedMap<Integer, String> processes() {
        return Collections.emptySortedMap();
    }

    /**
     * Starts a process in status Stopped. Its end, however caused, is reported by the owner to {@link
     * VeriCommand#processEnded}, after this has returned.
     *
     * @param number a key of {@link #processes}
     * @param operator who orders it: a number, or the name of a program's operator; empty if the network does not say
     */
    default void startProcess(int number, String operator) {
        throw new IllegalArgumentException("process " + number + ": this robot has none");
    }

    /** True if the running process has requested the keys of the call that started it. */
    default boolean takesKeys() {
        return false;
    }

    /** Gives a key of the call to such a process. */
    default void pressKey(char key) {}

    /** The true pose. */
    Pose pose();
}
