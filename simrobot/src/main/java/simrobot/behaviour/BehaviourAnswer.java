package simrobot.behaviour;

import java.util.ArrayList;
import java.util.List;

/**
 * A process's answer to its senses, with all its requests; immutable.
 *
 * @param steering null if it returned none
 */
public record BehaviourAnswer(Steering steering, boolean isDone, List<BehaviourRequest> asked) {
    private static final int MOST_REQUESTS = 1000;
    /** Further prints are dropped, so that they leave room for other requests. */
    private static final int MOST_PRINTS = 500;

    private static final ThreadLocal<List<BehaviourRequest>> NOW = new ThreadLocal<>();

    /** Has a process decide, on this thread. */
    public static BehaviourAnswer of(Behaviour behaviour, Senses senses) {
        List<BehaviourRequest> asked = new ArrayList<>();
        NOW.set(asked);
        try {
            Steering steering = behaviour.decide(senses);
            return new BehaviourAnswer(steering, behaviour.isDone(), List.copyOf(asked));
        } finally {
            NOW.remove();
        }
    }

    /** True while a process decides on this thread. */
    public static boolean isOpen() {
        return NOW.get() != null;
    }

    /** Notes a request of the process that decides on this thread. */
    public static void ask(BehaviourRequest request) {
        if (request instanceof BehaviourRequest.Printed && isOpen() && NOW.get().size() >= MOST_PRINTS) {
            return;
        }
        if (!isOpen() || NOW.get().size() == MOST_REQUESTS) {
            throw new IllegalStateException(
                    isOpen() ? "more than 1000 requests in a decision, expected fewer" : "expected within decide");
        }
        NOW.get().add(request);
    }
}
