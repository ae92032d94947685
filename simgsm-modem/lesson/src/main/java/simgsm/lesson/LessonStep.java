package simgsm.lesson;

import java.util.List;
import java.util.Optional;

/**
 * A step of a lesson, with its own lamp.
 *
 * @param name in texts and results
 * @param after step to be done before this one's conditions count; empty for none
 * @param again events that begin a new try and reset the counts; empty for a single try
 * @param answer name of the student's answer at this step; empty for none
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
