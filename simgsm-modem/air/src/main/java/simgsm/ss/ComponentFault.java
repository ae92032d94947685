package simgsm.ss;

import java.util.Optional;

/** A received component that breaks the protocol; {@link #answer} is the standard's reply. */
public final class ComponentFault extends Exception {
    private final transient Component.Reject answer;

    ComponentFault(Optional<Integer> id, SsProblem problem, String text) {
        super(problem.title() + ": " + text, null, false, false);
        answer = new Component.Reject(id, problem);
    }

    /** The reject component for the sender. */
    public Component.Reject answer() {
        return answer;
    }
}
