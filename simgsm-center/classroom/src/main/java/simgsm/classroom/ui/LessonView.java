package simgsm.classroom.ui;

import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A lesson at one moment, with the student's numbers in its texts.
 *
 * @param seed of the student's numbers
 * @param steps in order
 * @param running names of the running programs
 * @param notice the latest notice, such as a failed action; may be empty
 */
public record LessonView(long seed, boolean isPredicted, List<StepView> steps, Set<String> running, String notice) {
    public LessonView {
        steps = List.copyOf(steps);
        running = Set.copyOf(running);
    }

    /**
     * A step waits for earlier ones, waits for its events, is done, or can be done in a new try, or only in a new run.
     */
    public enum StepState {
        LATER,
        OPEN,
        DONE,
        SPOILT,
        LOST
    }

    /**
     * @param tried whether an answer was given
     * @param counts what the step counts, such as {@code 2/3}; empty for nothing
     */
    public record StepView(String name, StepState state, boolean tried, String counts) {}

    public boolean isDone() {
        return steps.stream().allMatch(step -> step.state() == StepState.DONE);
    }

    public long score() {
        return steps.stream().filter(step -> step.state() == StepState.DONE).count();
    }

    /** The steps by name. */
    Map<String, StepView> byName() {
        return steps.stream().collect(java.util.stream.Collectors.toMap(StepView::name, step -> step));
    }
}
