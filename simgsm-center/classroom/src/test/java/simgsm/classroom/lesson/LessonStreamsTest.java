package simgsm.classroom.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.console.Event;
import simgsm.lesson.Lesson;
import simgsm.lesson.LessonLibrary;
import simgsm.lesson.LessonRun;
import simgsm.lesson.LessonStep;

/**
 * Every lesson's conditions with recorded events, without programs. A file for each lesson: {@code == NAME: STEP...} begins a
 * pupil's way and names the steps that it does ({@code all}, {@code none}); then {@code SOURCE EVENT}, {@code answer NAME TEXT}
 * and {@code play NAME} a line each. {@code right} and {@code wrong} were recorded from the lesson's solutions with seed 1; the
 * others are what a clever pupil would try who does not do what the step's text says.
 */
class LessonStreamsTest {
    private static final LessonLibrary LIBRARY = LessonLibrary.ofSuite();

    /** Steps that a new try cannot pass once they went wrong: a pressed key stays pressed. */
    private static final Map<String, List<String>> LOST = Map.of("forge-an-order", List.of("no-keys"));

    /** A pupil's way through a lesson. */
    private record Way(List<String> done, List<String> lines) {}

    private static Map<String, Way> ways(String lesson) throws Exception {
        Map<String, Way> ways = new LinkedHashMap<>();
        Way way = null;
        try (var in = LessonStreamsTest.class.getResourceAsStream("/lesson-ways/" + lesson + ".txt")) {
            for (String line : new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .toList()) {
                if (line.startsWith("== ")) {
                    int colon = line.lastIndexOf(": ");
                    way = new Way(List.of(line.substring(colon + 2).split(" ")), new ArrayList<>());
                    ways.put(line.substring(3, colon), way);
                } else if (!line.isBlank()) {
                    way.lines().add(line);
                }
            }
        }
        return ways;
    }

    static Stream<Arguments> all() throws Exception {
        List<Arguments> all = new ArrayList<>();
        for (String lesson : LIBRARY.names()) {
            ways(lesson).keySet().forEach(way -> all.add(Arguments.of(lesson, way)));
        }
        return all.stream();
    }

    static Stream<String> names() {
        return LIBRARY.names().stream();
    }

    private static LessonRun run(String lesson) throws Exception {
        return new LessonRun(LIBRARY.lesson(lesson), 1, new LessonFigures());
    }

    private static void play(LessonRun run, String name) throws Exception {
        Map<String, Way> ways = ways(run.lesson().name());
        for (String line : ways.get(name).lines()) {
            String[] words = line.split(" ", 3);
            switch (words[0]) {
                case "play" -> play(run, words[1]);
                case "answer" -> run.answer(words[1], run.solved(words[2]));
                default -> run.event(words[0], Event.parse(line.substring(words[0].length() + 1)));
            }
        }
    }

    private static List<String> done(LessonRun run) {
        return run.lesson().steps().stream()
                .map(LessonStep::name)
                .filter(run::isDone)
                .toList();
    }

    private static List<String> steps(Lesson lesson) {
        return lesson.steps().stream().map(LessonStep::name).toList();
    }

    @ParameterizedTest(name = "{0}: {1}")
    @MethodSource("all")
    void aWayDoesTheStepsWhoseTextsItFulfilsAndNoOther(String lesson, String way) throws Exception {
        LessonRun run = run(lesson);
        play(run, way);
        List<String> expected = ways(lesson).get(way).done();
        assertEquals(
                expected.equals(List.of("all"))
                        ? steps(run.lesson())
                        : expected.equals(List.of("none")) ? List.of() : expected,
                done(run));
    }

    @ParameterizedTest
    @MethodSource("names")
    void afterAWrongWayTheRightOnePasses(String lesson) throws Exception {
        LessonRun run = run(lesson);
        play(run, "wrong");
        play(run, "right");
        List<String> expected = new ArrayList<>(steps(run.lesson()));
        expected.removeAll(LOST.getOrDefault(lesson, List.of()));
        assertEquals(expected, done(run));
        assertTrue(
                run.lesson().steps().stream()
                        .anyMatch(step -> run.result(step.name()).tries() > 1),
                "tries of the wrong way count");
    }

    @ParameterizedTest
    @MethodSource("names")
    void nothingAndEmptyAnswersPassNoStep(String lesson) throws Exception {
        LessonRun run = run(lesson);
        for (LessonStep step : run.lesson().steps()) {
            step.answer().ifPresent(answer -> run.answer(answer, " "));
        }
        assertEquals(List.of(), done(run));
    }

    /** Each lesson is tried as a pupil would who reads its conditions and not its texts. */
    @ParameterizedTest
    @MethodSource("names")
    void everyLessonHasWaysOfACleverPupil(String lesson) throws Exception {
        assertTrue(ways(lesson).size() > 2, ways(lesson).keySet().toString());
    }
}
