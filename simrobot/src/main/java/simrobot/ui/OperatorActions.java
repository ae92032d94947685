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
 * Actions of the window's user; each is passed to the thread that owns the changed object. Answers may arrive on any
 * thread: empty on success, else the reason in the window's language. Actions with an empty body exist only in a
 * running simulation or only in a recording.
 */
public interface OperatorActions {
    default void setPower(String robot, boolean on) {}

    default void setMotors(String robot, boolean on) {}

    /** Moves a robot at rest, if there is space. */
    void place(String robot, double xMeters, double yMeters, double headingRadians, Consumer<Placement> answer);

    /**
     * Adds a robot with a modem.
     *
     * @param place empty for the first free home
     */
    void addRobot(String name, String number, Optional<Pose> place, Consumer<Optional<String>> answer);

    default void removeRobot(String robot) {}

    /** Stops the robot with its deceleration. */
    default void brake(String robot) {}

    /** Begins a process, or ends it with NONE. */
    default void setBehaviour(String robot, BehaviourKind kind) {}

    /** Selects the robot with sonars in the snapshots and audible calls. */
    void watch(String robot);

    /** Changes the input of the robot's tone scope; its modem's input is unchanged. */
    default void tryOut(String robot, ToneExperiment experiment) {}

    /** Simulated seconds per second; infinity for unlimited. */
    void setSpeed(double simulatedSecondsPerSecond);

    void setPaused(boolean paused);

    /** Makes one step while paused. */
    void stepOnce();

    /**
     * Replaces the world; robots that would overlap a wall are moved to homes.
     *
     * @param file of the world, or the proposal for an unsaved one
     */
    void apply(World world, Path file, Consumer<Optional<String>> answer);

    /** Writes a world to a .map file. */
    void save(World world, Path file, Consumer<Optional<String>> answer);

    /** Writes a copy of an unsaved draft; does nothing in a read-only folder. */
    default void keep(World draft, Path file) {}

    /** Deletes that copy, or cancels its write. */
    default void dropKept(Path file) {}

    /** Writes a picture of the world (.png, .svg) or the robot's track (.csv), selected by the extension. */
    void export(String robot, Path file, Consumer<Optional<String>> answer);

    /** Jumps to a simulated time of a recording. */
    default void seek(long nanos) {}

    /** Begins to record the session in a file, or ends it when empty; errors are shown as a notice. */
    default void record(Optional<Path> file) {}

    /** Shows a message as {@link WindowSnapshot#notice}. */
    void tell(String message);

    /** The worlds recently chosen by the user, newest first. */
    default List<Path> recentWorlds() {
        return List.of();
    }

    /** Loads another world; errors are shown as a notice. */
    default void load(Path worldFile) {}
}
