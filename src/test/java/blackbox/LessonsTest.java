package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Every lesson's right solution passes with real programs; what does not is {@code LessonStreamsTest}'s. */
@Execution(ExecutionMode.CONCURRENT)
class LessonsTest {
    private static final String OWN = "docs/lessons/own";
    private static final Pattern SCORE = Pattern.compile("score=([0-9]+) of=([0-9]+)");

    static Stream<String> lessons() throws Exception {
        return FinishedProgram.run("simgsm-center", "--lessons", "--lang", "en")
                .output()
                .lines()
                .map(line -> line.replaceFirst("lesson name=(\\S+) .*", "$1"));
    }

    @ParameterizedTest
    @MethodSource("lessons")
    void theRightSolutionPassesEveryStep(String lesson) throws Exception {
        FinishedProgram run =
                FinishedProgram.run("simgsm-center", "--lesson", lesson, "--check", "right", "--lang", "en");
        assertEquals(0, run.status(), run.output() + run.error());
        Matcher score = score(run);
        assertEquals(score.group(2), score.group(1), run.output());
        assertTrue(
                run.output()
                                .lines()
                                .filter(line -> line.startsWith("check step="))
                                .count()
                        > 2,
                run.output());
    }

    private static Matcher score(FinishedProgram run) {
        String last = run.output().lines().reduce("", (first, second) -> second);
        Matcher score = SCORE.matcher(last);
        assertTrue(score.matches(), run.output() + run.error());
        return score;
    }

    /** A lesson without programs, so that no other process has to start; the lines of its steps and a solution are the test's. */
    private static FinishedProgram mine(Path folder, String lesson, String solution, String... options)
            throws Exception {
        Path mine = Files.createDirectories(folder.resolve("lessons/mine"));
        Files.writeString(mine.resolve("lesson.txt"), "minutes 5\n" + lesson);
        Files.writeString(mine.resolve("en.txt"), """
                title: Mine
                task: Do it.
                predict: What?
                question: Why?
                step a: Do it
                hint a: Try it
                action act: Act
                """.replaceAll(lesson.contains("action") ? "$^" : "action.*\n", ""));
        Path file = Files.writeString(folder.resolve("mine.txt"), solution);
        List<String> words = new ArrayList<>(List.of(
                "--lessons", folder.resolve("lessons").toString(), "--lesson", "mine", "--check", file.toString()));
        words.addAll(List.of(options));
        return FinishedProgram.run("simgsm-center", words.toArray(String[]::new));
    }

    @Test
    void aStudentsOwnFileIsPlayedAndItsResultWritten(@TempDir Path folder) throws Exception {
        Path result = folder.resolve("result.txt");
        FinishedProgram run = mine(
                folder,
                "draw n from 7\nstep a\nanswer key\nwhen student key n1={n}",
                "predict none\nanswer key 1 2\nhint a\nanswer key 3",
                "--seed",
                "5",
                "--result",
                result.toString());
        assertEquals(1, run.status(), run.output() + run.error());
        String text = Files.readString(result);
        assertTrue(text.startsWith("result lesson=mine student=\"\" seed=5 time="), text);
        assertTrue(text.contains("\nnumbers n=7\nprediction text=none\nanswer name=key text=3\n"), text);
        assertTrue(text.contains("\nstep name=a result=fail tries=2 hints=1\nscore of=1 passed=0\ncopy text="), text);
    }

    @Test
    void aStudentsFileCannotSendWhatIsToBeFound(@TempDir Path folder) throws Exception {
        String lesson = "let hex submit 5550200 1\nstep a\nwhen tool pdu status=0\naction act text\n"
                + "do tool pdu decode \"{input}\"";
        FinishedProgram run = mine(folder, lesson, "act act {hex}");
        assertEquals(1, run.status(), run.output() + run.error());
        assertTrue(run.output().contains("check step=a result=fail"), run.output());
    }

    @Test
    void aSignalLeavesNoFolderBehind(@TempDir Path folder) throws Exception {
        Path temporary = Files.createDirectory(folder.resolve("temporary"));
        Path solution = Files.write(folder.resolve("mine.txt"), List.of("robot wait never 60"));
        List<String> command = Dist.command(
                temporary,
                "simgsm-center",
                List.of("--lesson", "twelve-keys", "--check", solution.toString(), "--log-level", "debug"));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        try (BufferedReader lines = process.inputReader()) {
            String line = lines.readLine();
            while (line != null && !line.contains("registered number=")) {
                line = lines.readLine();
            }
            process.toHandle().destroy();
            lines.transferTo(Writer.nullWriter());
        }
        process.waitFor();
        try (Stream<Path> left = Files.list(temporary)) {
            assertEquals(List.of(), left.toList());
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '!',
            value = {
                "use ../secret.txt ! line 1: use: expected the name of a file beside the solution, found ../secret.txt",
                "act act 50 ! Se espera un número entero de 0 a 40, y hay 50",
                "tool ! line 1: expected more words"
            })
    void aLineThatCannotBePerformedIsNamed(String line, String expected, @TempDir Path folder) throws Exception {
        FinishedProgram run = mine(
                folder,
                "step a\nwhen tool tones\naction act integer 0..40\ndo tool tones {input} x.wav",
                line,
                "--lang",
                "es");
        assertEquals(1, run.status(), run.output() + run.error());
        assertTrue(run.error().contains(expected), run.error());
        assertTrue(run.output().contains("check step=a result=fail"), run.output());
        assertTrue(run.output().contains("score=0 of=1"), run.output());
    }

    @Test
    void aTeachersOwnLessonIsListedAndPlayed(@TempDir Path folder) throws Exception {
        List<String> listed = FinishedProgram.run("simgsm-center", "--lessons", OWN, "--lang", "es")
                .output()
                .lines()
                .toList();
        assertEquals(lessons().count() + 1, listed.size());
        assertEquals("lesson name=corridor title=\"El final del pasillo\" minutes=10", listed.get(listed.size() - 1));
        Path result = folder.resolve("result.txt");
        FinishedProgram right = FinishedProgram.run(
                "simgsm-center",
                "--lessons",
                OWN,
                "--lesson",
                "corridor",
                "--check",
                "right",
                "--result",
                result.toString());
        assertEquals(0, right.status(), right.output() + right.error());
        assertTrue(right.output().endsWith("score=3 of=3\n"), right.output());
        assertTrue(Files.readString(result).contains("\nnumbers cm="), Files.readString(result));
    }

    @Test
    void faultsInATeachersLessonAreNamedWithFileAndLine(@TempDir Path folder) throws Exception {
        Path mine = Files.createDirectory(folder.resolve("mine"));
        for (String file : List.of("en.txt", "es.txt", "corridor.map")) {
            Files.copy(Dist.root().resolve(OWN).resolve("corridor").resolve(file), mine.resolve(file));
        }
        String lesson = Files.readString(Dist.root().resolve(OWN).resolve("corridor/lesson.txt"));
        Files.writeString(mine.resolve("lesson.txt"), lesson.replace("when robot status", "when robo status"));
        FinishedProgram list = FinishedProgram.run("simgsm-center", "--lessons", folder.toString());
        assertEquals(1, list.status(), list.output());
        assertEquals(lessons().count(), list.output().lines().count());
        assertEquals(
                "simgsm-center: " + mine.resolve("lesson.txt") + ", line 13: expected a source of centre, phone, robot,"
                        + " student, tool, trace; found robo\n",
                list.error());
        FinishedProgram check = FinishedProgram.run(
                "simgsm-center", "--lessons", folder.toString(), "--lesson", "mine", "--check", "right");
        assertEquals(2, check.status(), check.output());
        assertTrue(check.error().contains("lesson.txt, line 13: expected a source"), check.error());
        Files.writeString(mine.resolve("lesson.txt"), lesson);
        FinishedProgram without = FinishedProgram.run(
                "simgsm-center", "--lessons", folder.toString(), "--lesson", "mine", "--check", "right");
        assertEquals(1, without.status(), without.output());
        assertTrue(without.error().contains(mine.resolve("right.txt") + ": no such file"), without.error());
        FinishedProgram nowhere = FinishedProgram.run("simgsm-center", "--lessons", mine.toString());
        assertEquals(2, nowhere.status(), nowhere.output());
        assertTrue(nowhere.error().contains("expected a folder with a folder for each lesson"), nowhere.error());
    }

    @Test
    void anUnknownLessonIsAUsageError() throws Exception {
        FinishedProgram run = FinishedProgram.run("simgsm-center", "--lesson", "nothing", "--check", "right");
        assertEquals(2, run.status(), run.error());
        assertTrue(run.error().contains("twelve-keys"), run.error());
    }
}
