package vericommand;

import java.util.Optional;

/**
 * How far an order of a program is; immutable.
 *
 * @param operator whom the program acts for
 * @param keys as received, without blanks
 * @param verdict once it is known, {@link Verdict#word}
 * @param reply the newest; a process that is started has one before its end
 * @param pose of the robot when this was reported
 */
public record OrderReport(
        String operator, String keys, Optional<String> verdict, State state, Optional<Reply> reply, Pose pose) {
    /** From verification to the last reply. */
    public enum State {
        /** Not verified yet, or stopping the robot. */
        WAITING,
        MOVING,
        ENDED
    }
}
