package simgsm.classroom.lesson;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import simgsm.classroom.ui.ClassroomTexts;
import simgsm.console.Event;
import simgsm.lesson.LessonRun;
import simgsm.lesson.LessonStep;
import simgsm.lesson.StepResult;

/** The result of a lesson as a text file: event lines, the last one says that anybody can change such a copy. */
final class ResultText {
    private ResultText() {}

    static String text(LessonRun run, String student, Instant at, Locale language) {
        StringBuilder text = new StringBuilder();
        text.append(Event.of("result")
                        .with("lesson", run.lesson().name())
                        .with("student", student)
                        .with("seed", run.seed())
                        .with("time", at.truncatedTo(ChronoUnit.SECONDS)))
                .append('\n');
        Event numbers = Event.of("numbers");
        for (Map.Entry<String, String> each : new TreeMap<>(run.drawn()).entrySet()) {
            numbers = numbers.with(each.getKey(), each.getValue());
        }
        text.append(numbers).append('\n');
        text.append(Event.of("prediction").with("text", run.prediction())).append('\n');
        run.answers()
                .forEach((name, answer) -> text.append(
                                Event.of("answer").with("name", name).with("text", answer))
                        .append('\n'));
        for (LessonStep step : run.lesson().steps()) {
            StepResult result = run.result(step.name());
            text.append(Event.of("step")
                            .with("name", step.name())
                            .with("result", result.word())
                            .with("tries", result.tries())
                            .with("hints", result.hints()))
                    .append('\n');
        }
        text.append(Event.of("score").with("of", run.lesson().steps().size()).with("passed", run.score()))
                .append('\n');
        return text + Event.of("copy")
                        .with("text", ClassroomTexts.in(language).of("lesson.copy"))
                        .toString() + "\n";
    }
}
