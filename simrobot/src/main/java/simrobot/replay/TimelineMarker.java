package simrobot.replay;

/**
 * A moment of a session that one looks for on a timeline.
 *
 * @param timeNanos simulated time
 * @param robot whose moment it is; empty for nobody's
 * @param line the whole event as the console had it
 */
public record TimelineMarker(long timeNanos, Kind kind, String robot, String line) {
    /** What happened. */
    public enum Kind {
        /** An order was read and verified. */
        ORDER,
        /** A robot came into Collision. */
        COLLISION,
        /** An order was answered. */
        REPLY,
        /** A call came or was released. */
        CALL
    }
}
