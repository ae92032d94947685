package simrobot.replay;

/**
 * A marked moment of a session.
 *
 * @param timeNanos simulated time
 * @param robot the robot's name; empty if the event belongs to none
 * @param line the line that the console prints
 */
public record TimelineMarker(long timeNanos, Kind kind, String robot, String line) {
    /** Kind of the marked event. */
    public enum Kind {
        /** An order was read and verified. */
        ORDER,
        /** A robot entered Collision. */
        COLLISION,
        /** An order was answered. */
        REPLY,
        /** A call was received or released. */
        CALL
    }
}
