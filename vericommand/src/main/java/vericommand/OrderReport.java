package vericommand;

import java.util.Locale;
import java.util.Optional;

/**
 * The progress of a program's order; immutable.
 *
 * @param verdict {@link Verdict#word}; empty until it is known
 * @param reply the newest; the start of a process has a reply, too
 * @param pose the robot's, at the time of this report
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
