package simrobot.control;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import simgsm.console.Event;
import simgsm.event.EventLine;

/** A console answer that is not an event of a robot. */
public interface ConsoleRow {
    /** The line as printed. */
    default Event line() {
        return Event.from(this);
    }

    /** Answer to {@code speed}; 0: paused. */
    @EventLine("speed value=")
    record Speed(String value) implements ConsoleRow {}

    /** Answer to {@code step}; the simulated time in seconds. */
    @EventLine("step count= time=timeSeconds:2")
    record Steps(int count, double timeSeconds) implements ConsoleRow {}

    /** 16 ranges in mm, sonar 0 first, measured up to 320 ms ago while the robot moves. */
    @EventLine("sonar robot= ranges=")
    record SonarRanges(String robot, List<Integer> ranges) implements ConsoleRow {}

    /** 181 ranges in mm, from -90 degrees (right) to 90 (left); 32000 without an obstacle. */
    @EventLine("laser robot= ranges=")
    record LaserRanges(String robot, List<Integer> ranges) implements ConsoleRow {}

    /** Answer to {@code robots}. */
    @EventLine("robot robot=name number=")
    record RobotRow(String name, String number) implements ConsoleRow {}

    /** Answer to {@code world}, with and without a file. */
    @EventLine("world name= lines= points= homes=")
    record WorldRow(String name, int lines, int points, int homes) implements ConsoleRow {}

    /** Answer to {@code camera}. */
    @EventLine("camera robot= file= width= height=")
    record CameraWritten(String robot, Path file, int width, int height) implements ConsoleRow {}

    /** Answer to {@code export}. */
    @EventLine("exported robot= file=")
    record Exported(String robot, Path file) implements ConsoleRow {}

    /** Answer to {@code behaviours}; an order starts a process by its number, {@code ** #*1 **}. */
    @EventLine("behaviour [number=] name=")
    record BehaviourRow(OptionalInt number, String name) implements ConsoleRow {}

    /** A file of {@code --behaviours} is compiled. */
    @EventLine("behaviour-loaded name=")
    record BehaviourLoaded(String name) implements ConsoleRow {}

    /** A file of {@code --behaviours} was removed. */
    @EventLine("behaviour-removed name=")
    record BehaviourRemoved(String name) implements ConsoleRow {}
}
