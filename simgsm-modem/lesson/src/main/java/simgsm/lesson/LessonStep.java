package simgsm.lesson;

import java.util.List;
import java.util.Optional;

/**
 * A step of a lesson, with a lamp of its own.
 *
 * @param name by which texts and results refer to it
 * @param after the step that has to be done before its conditions count; empty for none
 * @param again events of which each begins a new try: what was counted is forgotten; empty for one try alone
 * @param answer the name of the answer that the student types here; empty for none
 */
public record LessonStep(
        String name,
        Optional<String> after,
        List<EventPattern> again,
        Optional<String> answer,
        List<LessonCondition> conditions) {
    public LessonStep {
        again = List.copyOf(again);
        conditions = List.copyOf(conditions);
    }
}
