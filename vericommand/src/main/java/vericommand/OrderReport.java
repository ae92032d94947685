package vericommand;

import java.util.Locale;
import java.util.Optional;

/**
 * The progress of a program's order; immutable.
 *
 * @param verdict once it is known, {@link Verdict#word}
 * @param reply the newest; a process that is started has one before its end
 * @param pose of the robot when this was reported
 */
public record OrderReport(Optional<String> verdict, State state, Optional<Reply> reply, Pose pose) {
    /** From verification to the last reply. */
    public enum State {
        /** Not verified yet, or stopping the robot. */
        WAITING,
        MOVING,
        ENDED;

        /** The name in small letters, for consoles and JSON. */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }
}
