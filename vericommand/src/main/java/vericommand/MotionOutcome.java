package vericommand;

/**
 * Outcome of one motion. {@link Robot#status()} has changed accordingly before the outcome is delivered.
 *
 * @param amountDone distance or angle done, 0 or more: centimetres of a forward, degrees of a turn
 */
public record MotionOutcome(Ending ending, double amountDone) {
    /** The endings of a motion. */
    public enum Ending {
        /** The goal is reached. */
        DONE,
        /** The robot touched something, or a turn made in Collision left the way ahead blocked. */
        COLLISION,
        /** The watchdog ended it. */
        INFINITE_LOOP,
        /** {@link Robot#brake()} ended it; the robot has stopped. */
        BRAKED,
        /** Motors or power went off, as the robot's status says; in status Stopped: the world was changed. */
        ABORTED
    }

    public MotionOutcome {
        if (!(amountDone >= 0 && amountDone < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a motion's amount done is 0 or more, not " + amountDone);
        }
    }
}
