package simgsm.classroom.lesson;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.HexFormat;
import java.util.Map;
import java.util.TreeMap;
import simgsm.console.Event;
import simgsm.lesson.LessonRun;
import simgsm.lesson.LessonStep;

/**
 * The result of a lesson for the teacher: event lines, the last one with a hash over those above it. The hash shows that a
 * file is as the program wrote it; it is no secret, so it shows carelessness and no fraud.
 */
final class LessonResult {
    private LessonResult() {}

    static String text(LessonRun run, String student, Instant at) {
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
            text.append(Event.of("step")
                            .with("name", step.name())
                            .with("result", run.isDone(step.name()) ? "pass" : "fail"))
                    .append('\n');
        }
        text.append(Event.of("score").with("of", run.lesson().steps().size()).with("passed", run.score()))
                .append('\n');
        return text + Event.of("hash").with("sha256", hash(text.toString())).toString() + "\n";
    }

    private static String hash(String text) {
        try {
            return HexFormat.of()
                    .formatHex(MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8)));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e); // every Java has it
        }
    }
}
