package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code --grade DIR}: what a file does to its program is its own result. */
class GradeTest {
    @TempDir
    Path folder;

    private void write(String name, String decide) throws IOException {
        Files.writeString(
                folder.resolve(name + ".java"),
                "import simrobot.behaviour.*;\n"
                        + "public class " + name + " implements Behaviour {\n"
                        + "    private boolean done;\n"
                        + "    public Steering decide(Senses senses) {\n"
                        + "        " + decide + "\n"
                        + "        done = senses.seconds() > 3;\n"
                        + "        return new Steering(0.3, 0);\n"
                        + "    }\n"
                        + "    public boolean isDone() { return done; }\n"
                        + "}\n");
    }

    @Test
    void eachFileOfAClassHasARowWhateverItDoes() throws Exception {
        write("Good", "");
        write("Misspelt", "senses.sonar(3);");
        write("Exits", "if (senses.seconds() > 1) System.exit(0);");
        write("Halts", "Runtime.getRuntime().halt(3);");
        write("Loops", "while (senses.seconds() > 1) {}");
        write("Throws", "if (!done) throw new IllegalStateException(\"<b>, \\\"&\\\"\");");
        FinishedProgram graded = FinishedProgram.run(
                "simrobot", "--world=" + Scenario.world("office.map"), "--grade=" + folder, "--lang=en");
        assertEquals(0, graded.status(), graded.error());
        List<String> lines = graded.output().lines().toList();
        assertEquals(7, lines.size(), graded.output());
        assertEquals("end of=grade count=6", lines.get(6));
        List<String> rows = Files.readAllLines(folder.resolve("grades.csv"));
        assertEquals("name,seed,state,robots,done,seconds,meters,collisions,text", rows.get(0));
        assertTrue(rows.get(1).startsWith("Good,1,done,1,1,"), rows.get(1));
        assertEquals(7, rows.size());
        assertTrue(
                rows.get(2).startsWith("Exits,1,failed,1,0,2.100,0.315,0,\"line 5: System.exit is called ("),
                rows.toString());
        assertTrue(
                rows.stream()
                        .anyMatch(
                                row -> row.startsWith(
                                        "Halts,1,failed,1,0,0.060,0.000,0,\"line 5: it has ended its process, exit status 3 (")),
                rows.toString());
        String page = Files.readString(folder.resolve("grades.html"));
        assertTrue(page.contains("<td>Good</td><td>1 / 1</td>"), page);
        assertTrue(page.contains("failed: line 5: IllegalStateException: &lt;b&gt;, &quot;&amp;&quot;"), page);
        assertTrue(page.contains("failed: line 5: no decision within 1 s: it computes without end"), page);
        assertTrue(
                page.contains(
                        "<td>Misspelt</td><td>0 / 1</td><td></td><td></td><td>failed: line 5: cannot find symbol"),
                page);
        assertFalse(Files.exists(folder.resolve("numbers.txt")));
    }

    @Test
    void aFileThatDoesNotCompileHasARowForEachRun() throws Exception {
        write("Misspelt", "senses.sonar(3);");
        FinishedProgram graded = FinishedProgram.run(
                "simrobot",
                "--world=" + Scenario.world("office.map"),
                "--grade=" + folder,
                "--lang=en",
                "--seed=5",
                "--runs=3");
        assertEquals(0, graded.status(), graded.error());
        List<String> rows = Files.readAllLines(folder.resolve("grades.csv"));
        assertEquals(4, rows.size(), rows.toString());
        for (int i = 1; i <= 3; i++) {
            assertTrue(rows.get(i).startsWith("Misspelt," + (4 + i) + ",failed,1,0,"), rows.get(i));
        }
        String page = Files.readString(folder.resolve("grades.html"));
        assertTrue(page.contains("<td>Misspelt</td><td>0 / 3</td>"), page);
    }

    @Test
    void aRunUntilDoneTellsTheOutcomeOfARobotByItsExitStatus() throws Exception {
        write("Good", "");
        String[] options = {"--world=" + Scenario.world("office.map"), "--behaviours=" + folder, "--behaviour=Good"};
        FinishedProgram done = run(options, "--run=done", "--seed=1");
        assertEquals(0, done.status(), done.error());
        assertTrue(
                done.output()
                        .matches(
                                "(?s)ran .*outcome robot=robot name=Good state=done seconds=[0-9.]+ meters=[0-9.]+ text=\"\"\n"),
                done.output());
        FinishedProgram late = run(options, "--run=done", "--limit=2", "--goal=Exit");
        assertEquals(1, late.status(), late.error());
        assertTrue(late.output().contains(" state=timeout seconds=2.000 "), late.output());
        FinishedProgram nowhere = run(options, "--run=done", "--goal=Nowhere");
        assertEquals(2, nowhere.status());
        assertTrue(nowhere.error().contains("--goal: expected a home or goal of the world (Exit,"), nowhere.error());
        assertEquals(2, FinishedProgram.run("simrobot", "--run=done").status());
        assertEquals(2, run(options, "--run=5", "--limit=2").status());
    }

    private static FinishedProgram run(String[] options, String... more) throws Exception {
        return FinishedProgram.run(
                "simrobot",
                java.util.stream.Stream.of(options, more)
                        .flatMap(java.util.stream.Stream::of)
                        .toArray(String[]::new));
    }
}
