package simrobot.ui;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.dtmf.ToneExperiment;
import simrobot.behaviour.BehaviourKind;
import simrobot.robot.Placement;
import simrobot.world.World;
import vericommand.Pose;

/** What the person at the window may do; each act goes to the thread that owns what it touches. */
public interface OperatorActions {
    void setPower(String robot, boolean on);

    void setMotors(String robot, boolean on);

    /**
     * Puts a standing robot somewhere, if it fits there.
     *
     * @param answer told what became of it, by any thread
     */
    void place(String robot, double xMeters, double yMeters, double headingRadians, Consumer<Placement> answer);

    /**
     * Makes a robot with a modem of its own.
     *
     * @param place none: on the first home that is free
     * @param answer told by any thread: nothing when it is there, else why not
     */
    void addRobot(String name, String number, Optional<Pose> place, Consumer<Optional<String>> answer);

    void removeRobot(String robot);

    /** Brings the robot to rest with its own deceleration. */
    void brake(String robot);

    /** Has the robot go its own ways, or stop doing so. */
    void setBehaviour(String robot, BehaviourKind kind);

    /** Wants this robot's sonars in the pictures, however many robots there are. */
    void watch(String robot);

    /** What this robot's scope is to hear; its modem hears the call as it is. */
    void tryOut(String robot, ToneExperiment experiment);

    /** Simulated seconds per second; infinite is as fast as it can. */
    void setSpeed(double simulatedSecondsPerSecond);

    void setPaused(boolean paused);

    /** One step while paused. */
    void stepOnce();

    /**
     * Puts an edited world under the robots; who stands in its walls goes to a home.
     *
     * @param file where the world is, or is to be, saved
     * @param answer told by any thread: nothing when it is done, else why not
     */
    void apply(World world, Path file, Consumer<Optional<String>> answer);

    /**
     * Writes a world to a file, as a .map.
     *
     * @param answer told by any thread: nothing when it is on the disk, else why not
     */
    void save(World world, Path file, Consumer<Optional<String>> answer);

    /**
     * Writes a picture of the world (.png, .svg) or the robot's track (.csv), by the file's ending.
     *
     * @param answer told by any thread: nothing when it is on the disk, else why not
     */
    void export(String robot, Path file, Consumer<Optional<String>> answer);

    /** Jumps to a simulated time of a recording that is played. */
    void seek(long nanos);

    /** Begins to record the session in a file, or with none ends what was begun; a problem is told. */
    void record(Optional<Path> file);

    /** Something for the person at the window to read in {@link WindowSnapshot#notice}. */
    void tell(String message);

    /** Loads another world; a problem is told through {@link WindowSnapshot#notice}. */
    void load(Path worldFile);
}
