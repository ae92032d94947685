package simgsm.classroom.lesson;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import simgsm.classroom.ui.ClassroomTexts;
import simgsm.console.Event;
import simgsm.lesson.LessonRun;

/** The result of a lesson as a text file: event lines, the last one says that anybody can change such a copy. */
final class ResultText {
    private ResultText() {}

    static String text(LessonRun run, String student, Instant at, Locale language) {
        List<Event> events = new ArrayList<>();
        events.add(Event.of("result")
                .with("lesson", run.lesson().name())
                .with("student", student)
                .with("seed", run.seed())
                .with("time", at.truncatedTo(ChronoUnit.SECONDS)));
        Event numbers = Event.of("numbers");
        for (Map.Entry<String, String> each : new TreeMap<>(run.drawn()).entrySet()) {
            numbers = numbers.with(each.getKey(), each.getValue());
        }
        events.add(numbers);
        events.add(Event.of("prediction").with("text", run.prediction()));
        run.answers()
                .forEach((name, answer) ->
                        events.add(Event.of("answer").with("name", name).with("text", answer)));
        run.lesson().steps().stream()
                .map(step -> run.result(step.name()))
                .forEach(result -> events.add(Event.of("step")
                        .with("name", result.step())
                        .with("result", result.word())
                        .with("tries", result.tries())
                        .with("hints", result.hints())));
        events.add(Event.of("score").with("of", run.lesson().steps().size()).with("passed", run.score()));
        events.add(Event.of("copy").with("text", ClassroomTexts.in(language).of("lesson.copy")));
        return events.stream().map(event -> event + "\n").collect(Collectors.joining());
    }
}
