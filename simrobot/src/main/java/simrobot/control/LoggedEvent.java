package simrobot.control;

import simgsm.console.Event;

/**
 * An event in the log.
 *
 * @param timeNanos simulated time
 * @param line as the console prints it
 */
public record LoggedEvent(long timeNanos, Event line) {
    /** Creates a robot's event. The log shows an unknown type in the user's language, the console as an error. */
    public LoggedEvent(long timeNanos, String robot, RobotEvent event) {
        this(
                timeNanos,
                event instanceof RobotEvent.TypeUnknown unknown
                        ? Event.of("type-unknown").with("robot", robot).with("type", unknown.type())
                        : event.line(robot));
    }

    /** The robot's name; empty if the event belongs to none. */
    public String robot() {
        return line.fields().get("robot");
    }
}
