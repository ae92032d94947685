package simrobot.ui;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.tone.ToneExperiment;
import simrobot.process.BehaviourKind;
import simrobot.robot.Placement;
import simrobot.world.World;
import vericommand.Pose;

/**
 * What the window's user can do; each action is passed to the thread that owns what it changes. Answers come from any thread:
 * empty on success, else the reason in the window's language. Actions with an empty body are those that either a running
 * simulation or a recording does not have.
 */
public interface OperatorActions {
    default void setPower(String robot, boolean on) {}

    default void setMotors(String robot, boolean on) {}

    /** Moves a robot that stands still, if there is room. */
    void place(String robot, double xMeters, double yMeters, double headingRadians, Consumer<Placement> answer);

    /** Adds a robot with a modem of its own. @param place empty for the first free home */
    void addRobot(String name, String number, Optional<Pose> place, Consumer<Optional<String>> answer);

    default void removeRobot(String robot) {}

    /** Stops the robot with its own deceleration. */
    default void brake(String robot) {}

    /** Begins a process, or ends it with NONE. */
    default void setBehaviour(String robot, BehaviourKind kind) {}

    /** Selects the robot whose sonars are in the snapshots and whose calls are heard. */
    void watch(String robot);

    /** Changes what the robot's tone scope hears; its modem hears the call unchanged. */
    default void tryOut(String robot, ToneExperiment experiment) {}

    /** Simulated seconds per second; infinity for as fast as the machine can. */
    void setSpeed(double simulatedSecondsPerSecond);

    void setPaused(boolean paused);

    /** One step while paused. */
    void stepOnce();

    /**
     * Replaces the world; robots that would stand in a wall are moved to homes.
     *
     * @param file of the world, or the proposal for one that is not saved
     */
    void apply(World world, Path file, Consumer<Optional<String>> answer);

    /** Writes a world to a .map file. */
    void save(World world, Path file, Consumer<Optional<String>> answer);

    /** Writes a copy of a draft that is not saved; a folder that cannot be written to holds none. */
    default void keep(World draft, Path file) {}

    /** Deletes that copy, also one that is not written yet. */
    default void dropKept(Path file) {}

    /** Writes a picture of the world (.png, .svg) or the robot's track (.csv), by the file's ending. */
    void export(String robot, Path file, Consumer<Optional<String>> answer);

    /** Jumps to a simulated time of a recording. */
    default void seek(long nanos) {}

    /** Begins to record the session in a file, or ends it when empty; errors are shown as a notice. */
    default void record(Optional<Path> file) {}

    /** Shows a message as {@link WindowSnapshot#notice}. */
    void tell(String message);

    /** The worlds that the user has chosen lately, the newest first. */
    default List<Path> recentWorlds() {
        return List.of();
    }

    /** Loads another world; errors are shown as a notice. */
    default void load(Path worldFile) {}
}
