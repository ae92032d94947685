package simrobot.process;

import java.util.List;
import simrobot.behaviour.BehaviourRequest;
import simrobot.behaviour.Steering;

/** A decision of a process. */
public sealed interface Decision {
    /** The speeds until the next decision, and what else the process asks for. */
    record Go(Steering steering, List<BehaviourRequest> asked) implements Decision {
        public Go(Steering steering) {
            this(steering, List.of());
        }
    }

    /** A decision that ends the process: the robot brakes. */
    sealed interface End extends Decision {
        /** The requests of the process in its last decision. */
        default List<BehaviourRequest> asked() {
            return List.of();
        }
    }

    /** The process has reached what it was for. */
    record Done(List<BehaviourRequest> asked) implements End {}

    /** The robot has reached the place of its process. */
    record Arrived() implements End {}

    /**
     * The process cannot finish.
     *
     * @param text the reason, in English
     */
    record GivenUp(String text) implements End {}

    /** The process has not freed the robot from a collision. */
    record Collided() implements End {}

    /**
     * The process has thrown an exception, or decided too late.
     *
     * @param line of its source; 0 if unknown
     */
    record Failed(int line, String text, List<BehaviourRequest> asked) implements End {
        public Failed(int line, String text) {
            this(line, text, List.of());
        }

        /** {@code line 12: }, or empty. */
        public String where() {
            return line == 0 ? "" : "line " + line + ": ";
        }
    }

    /** Another process, an order, a brake or a switch has ended the process. */
    record Replaced() implements End {}
}
