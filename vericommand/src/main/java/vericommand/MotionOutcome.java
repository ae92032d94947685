package vericommand;

import java.util.Objects;

/**
 * How one motion ended. When it is told, {@link Robot#status()} has the status that follows from it already.
 *
 * @param amountDone how far the robot came in the motion's own unit: centimetres of a forward, degrees of a turn; 0 or
 *     more
 */
public record MotionOutcome(Ending ending, double amountDone) {
    /** The ways in which a motion ends. */
    public enum Ending {
        /** The goal is reached. */
        DONE,
        /** The robot touched something, or a turn made in Collision left the way ahead blocked. */
        COLLISION,
        /** The watchdog ended it. */
        INFINITE_LOOP,
        /** {@link Robot#brake()} ended it, the robot stands. */
        BRAKED,
        /** Motors or power went off, the robot's status says which; or, if it is Stopped, the world changed under it. */
        ABORTED
    }

    public MotionOutcome {
        Objects.requireNonNull(ending);
        if (!(amountDone >= 0 && amountDone < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a motion's amount done is 0 or more, not " + amountDone);
        }
    }
}
