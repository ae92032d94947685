package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every lesson is played with real programs: its right solution passes every step, its wrong one does not. */
@Execution(ExecutionMode.CONCURRENT)
class LessonsTest {
    private static final String OWN = "docs/lessons/own";
    private static final Pattern SCORE = Pattern.compile("score=([0-9]+) of=([0-9]+)");

    /** Tries of one value, or of a refused one, are no different ones; another process than the student's own is not it. */
    private static final Map<String, List<String>> OF_WRONG_SOLUTIONS = Map.of(
            "break-it", List.of("check step=tried result=fail"),
            "your-first-behaviour", List.of("check step=compiled result=pass", "check step=behaviour result=fail"));

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

    @ParameterizedTest
    @MethodSource("lessons")
    void theWrongSolutionFailsSomeSteps(String lesson) throws Exception {
        FinishedProgram run =
                FinishedProgram.run("simgsm-center", "--lesson", lesson, "--check", "wrong", "--lang", "es");
        assertEquals(1, run.status(), run.output() + run.error());
        Matcher score = score(run);
        assertTrue(Integer.parseInt(score.group(1)) < Integer.parseInt(score.group(2)), run.output());
        for (String step : OF_WRONG_SOLUTIONS.getOrDefault(lesson, List.of("result=fail"))) {
            assertTrue(run.output().contains(step), run.output());
        }
    }

    private static Matcher score(FinishedProgram run) {
        String last = run.output().lines().reduce("", (first, second) -> second);
        Matcher score = SCORE.matcher(last);
        assertTrue(score.matches(), run.output() + run.error());
        return score;
    }

    @Test
    void aStudentsOwnFileIsPlayedAndItsResultWritten(@TempDir Path folder) throws Exception {
        Path solution = Files.write(folder.resolve("mine.txt"), List.of("predict none", "answer key1 1 2"));
        Path result = folder.resolve("result.txt");
        FinishedProgram run = FinishedProgram.run(
                "simgsm-center",
                "--lesson",
                "twelve-keys",
                "--check",
                solution.toString(),
                "--seed",
                "5",
                "--result",
                result.toString());
        assertEquals(1, run.status(), run.output() + run.error());
        String text = Files.readString(result);
        assertTrue(text.startsWith("result lesson=twelve-keys student=\"\" seed=5 time="), text);
        assertTrue(text.contains("\nanswer name=key1 text=\"1 2\"\n"), text);
        assertTrue(text.contains("\nscore of=7 passed=0\ncopy text="), text);
    }

    @Test
    void aStudentsFileCannotSendWhatIsToBeFound(@TempDir Path folder) throws Exception {
        Path solution = Files.write(folder.resolve("mine.txt"), List.of("act send {hex}"));
        FinishedProgram run = FinishedProgram.run(
                "simgsm-center", "--lesson", "write-a-submit", "--check", solution.toString(), "--lang", "en");
        assertEquals(1, run.status(), run.output() + run.error());
        assertTrue(run.output().contains("check step=decoded result=fail"), run.output());
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

    @Test
    void aSolutionUsesFilesBesideItAlone(@TempDir Path folder) throws Exception {
        Path solution = Files.write(folder.resolve("mine.txt"), List.of("use ../secret.txt"));
        FinishedProgram run = FinishedProgram.run(
                "simgsm-center", "--lesson", "break-it", "--check", solution.toString(), "--lang", "en");
        assertEquals(1, run.status(), run.output() + run.error());
        assertTrue(
                run.error()
                        .contains("line 1: use: expected the name of a file beside the solution, found ../secret.txt"),
                run.error());
    }

    @Test
    void aNumberOutsideItsRangeIsRefusedInTheStudentsLanguage(@TempDir Path folder) throws Exception {
        Path solution = Files.write(folder.resolve("mine.txt"), List.of("act margin 50"));
        FinishedProgram run = FinishedProgram.run(
                "simgsm-center", "--lesson", "walk-through-town", "--check", solution.toString(), "--lang", "es");
        assertEquals(1, run.status(), run.output() + run.error());
        assertTrue(run.error().contains("Se espera un número entero de 0 a 40, y hay 50"), run.error());
        assertTrue(run.output().contains("check step=set result=fail"), run.output());
    }

    @Test
    void linesThatLackWordsAreNamed(@TempDir Path folder) throws Exception {
        Path solution = Files.write(folder.resolve("mine.txt"), List.of("tool"));
        FinishedProgram run = FinishedProgram.run(
                "simgsm-center", "--lesson", "twelve-keys", "--check", solution.toString(), "--lang", "en");
        assertEquals(1, run.status(), run.output() + run.error());
        assertTrue(run.error().contains("line 1: expected more words"), run.error());
        assertTrue(run.output().contains("score=0 of=7"), run.output());
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
        FinishedProgram wrong =
                FinishedProgram.run("simgsm-center", "--lessons", OWN, "--lesson", "corridor", "--check", "wrong");
        assertEquals(1, wrong.status(), wrong.output() + wrong.error());
        assertTrue(wrong.output().endsWith("score=1 of=3\n"), wrong.output());
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
