package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import blackbox.FinishedProgram;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Both solutions of every lesson in the languages, and with other numbers than in {@code LessonsTest}. Two
 * minutes on two cores: run by hand, with {@code -Ppeers -Dlessons.all=true}.
 */
@Tag("peer")
@EnabledIfSystemProperty(named = "lessons.all", matches = "true")
@Execution(ExecutionMode.CONCURRENT)
class LessonLanguagesTest {
    static Stream<String> lessons() throws Exception {
        return FinishedProgram.run("simgsm-center", "--lessons", "--lang", "es")
                .output()
                .lines()
                .map(line -> line.replaceFirst("lesson name=(\\S+) .*", "$1"));
    }

    @ParameterizedTest
    @MethodSource("lessons")
    void theRightSolutionPassesInSpanishWithOtherNumbers(String lesson) throws Exception {
        assertEnds(0, lesson, "right", "es");
    }

    @ParameterizedTest
    @MethodSource("lessons")
    void theWrongSolutionFailsInEnglishWithOtherNumbers(String lesson) throws Exception {
        assertEnds(1, lesson, "wrong", "en");
    }

    private static void assertEnds(int status, String lesson, String solution, String language) throws Exception {
        FinishedProgram run = FinishedProgram.run(
                "simgsm-center", "--lesson", lesson, "--check", solution, "--lang", language, "--seed", "77");
        assertEquals(status, run.status(), run.output() + run.error());
    }
}
