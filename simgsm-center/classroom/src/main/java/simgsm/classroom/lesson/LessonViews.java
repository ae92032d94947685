package simgsm.classroom.lesson;

import java.util.List;
import java.util.Set;
import simgsm.classroom.ui.LessonView;
import simgsm.lesson.LessonRun;
import simgsm.lesson.LessonStep;

/** Pictures of a run for its window. */
final class LessonViews {
    private LessonViews() {}

    static LessonView of(LessonRun run, Set<String> running, String notice) {
        List<LessonView.StepView> steps = run.lesson().steps().stream()
                .map(step -> new LessonView.StepView(
                        step.name(), state(run, step), isTried(run, step), String.join(", ", run.counts(step.name()))))
                .toList();
        return new LessonView(run.seed(), !run.prediction().isEmpty(), steps, running, notice);
    }

    private static LessonView.StepState state(LessonRun run, LessonStep step) {
        if (run.isDone(step.name())) {
            return LessonView.StepState.DONE;
        }
        if (run.isExceeded(step.name())) {
            return step.again().isEmpty() ? LessonView.StepState.LOST : LessonView.StepState.SPOILT;
        }
        boolean isLater = step.after().isPresent() && !run.isDone(step.after().get());
        return isLater ? LessonView.StepState.LATER : LessonView.StepState.OPEN;
    }

    private static boolean isTried(LessonRun run, LessonStep step) {
        return step.answer().isPresent()
                && run.answers().containsKey(step.answer().get());
    }
}
