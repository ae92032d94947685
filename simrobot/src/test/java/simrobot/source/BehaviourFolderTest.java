package simrobot.source;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.Writer;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.process.Decision;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.source.child.PipeLine;
import simrobot.world.Position;
import simrobot.world.World;
import vericommand.RobotStatus;

/** Processes from source files and jars, on a simulated robot. */
class BehaviourFolderTest {
    static final ChildSettings SETTINGS = ChildSettings.of(ChildSettings.DEFAULT_MEBIBYTES, Locale.ENGLISH);

    @TempDir
    Path folder;

    private final Simulation simulation = new Simulation(World.bare(), 1);
    private final BehaviourList list = simulation.behaviours();
    private final SimulatedRobot robot = simulation.addRobot("robot", new Position(0, 0), 0);
    private final List<String> told = new ArrayList<>();
    private BehaviourFolder opened;
    private final List<String> ends = new ArrayList<>();

    private final BehaviourFolder.Listener listener = new BehaviourFolder.Listener() {
        @Override
        public void loaded(BehaviourKind kind) {
            told.add("loaded " + kind);
        }

        @Override
        public void failed(String name, int line, String text) {
            told.add("failed " + name + " " + line + " " + text);
        }

        @Override
        public void removed(String name) {
            told.add("removed " + name);
        }
    };

    private static String source(String name, String decide) {
        return "import simrobot.behaviour.*;\n"
                + "public class " + name + " implements Behaviour {\n"
                + "    public Steering decide(Senses senses) {\n"
                + decide + "\n"
                + "    }\n"
                + "}\n";
    }

    private void write(String name, String decide) throws IOException {
        Path file = folder.resolve(name + ".java");
        Files.writeString(file, source(name, decide));
        // a clock of the file system may stand still between two versions
        Files.setLastModifiedTime(file, FileTime.fromMillis(1_000_000 + 1000L * told.size() + decide.length()));
    }

    static BehaviourFolder open(Path folder, BehaviourList list, BehaviourFolder.Listener listener) throws IOException {
        return new BehaviourFolder(
                folder, list, listener, SETTINGS, ToolProvider.getSystemJavaCompiler(), file -> true);
    }

    private BehaviourFolder open() throws IOException {
        opened = open(folder, list, listener);
        opened.waitForDecisions();
        return opened;
    }

    @AfterEach
    void endChildren() {
        if (opened != null) {
            opened.close();
        }
    }

    private void begin(String name) {
        robot.autonomy()
                .addEndListener((kind, how) -> ends.add(kind + " " + (how instanceof Decision.Done ? "Done" : how)));
        assertTrue(robot.autonomy().begin(list.of(name)));
    }

    private void runUntilItEnds() {
        runUntil(() -> !ends.isEmpty());
    }

    private void runUntil(BooleanSupplier done) {
        while (!done.getAsBoolean()) {
            assertTrue(simulation.timeNanos() < 3_600_000_000_000L, "not within an hour: " + ends);
            simulation.run(10);
        }
    }

    /** A decision of 70 ms: late in its first period of 50 ms, there in the second. */
    @Test
    void aFastSimulationWaitsForALateDecisionInItsNextPeriodToo() throws IOException {
        write(
                "Slow",
                "        java.util.concurrent.locks.LockSupport.parkNanos(70_000_000);\n"
                        + "        return new Steering(0.5, 0);");
        opened = open(folder, list, listener);
        begin("Slow");
        runUntil(() -> robot.xMeters() > 0);
        double begun = robot.xMeters();
        simulation.run(600);
        assertTrue(robot.xMeters() > begun + 0.01, robot.xMeters() + " m after " + begun);
    }

    @Test
    void aSourceFileDrivesARobot() throws IOException {
        write("Ahead", "        return new Steering(0.5, 0);");
        open();
        assertEquals(List.of("loaded Ahead"), told);
        begin("Ahead");
        // a decision that is late on a loaded machine makes the robot brake meanwhile
        while (robot.xMeters() < 1) {
            simulation.run(10);
        }
        assertEquals(RobotStatus.MOVING, robot.status());
        robot.autonomy().end();
        simulation.run(300);
        assertEquals(RobotStatus.STOPPED, robot.status());
    }

    @Test
    void theSameProcessMakesTheSameWayInEveryRun() throws IOException {
        write("Arc", "        return Steering.ofDegrees(0.3, 20 * senses.sonarMeters(3));");
        open();
        begin("Arc");
        simulation.run(500);
        opened.callDirectly(fault -> {});
        Simulation again = new Simulation(World.bare(), 1);
        SimulatedRobot other = again.addRobot("robot", new Position(0, 0), 0);
        other.autonomy().begin(list.of("Arc"));
        again.run(500);
        assertEquals(robot.xMeters(), other.xMeters());
        assertEquals(robot.headingRadians(), other.headingRadians());
    }

    @Test
    void aChangedFileReplacesTheProcessAndAnUnchangedOneStays() throws IOException {
        write("Ahead", "        return new Steering(0.5, 0);");
        write("Back", "        return new Steering(-0.5, 0);");
        open();
        told.clear();
        opened.scan();
        assertEquals(List.of(), told);
        write("Ahead", "        return new Steering(0.25, 0);");
        opened.scan();
        assertEquals(List.of("loaded Ahead"), told);
        Files.delete(folder.resolve("Back.java"));
        opened.scan();
        assertEquals(List.of("loaded Ahead", "removed Back"), told);
        assertEquals(List.of("wander", "wall-follow", "Ahead"), names());
    }

    private List<String> names() {
        return list.kinds().stream().map(BehaviourKind::text).toList();
    }

    @Test
    void allErrorsOfAFileAreToldAtOnce() throws IOException {
        write("Misspelt", "        return new Steerin(senses.sonar(3),\n x);");
        open();
        String fault = told.get(0);
        assertTrue(fault.startsWith("failed Misspelt 4 cannot find symbol; symbol:   class Steerin"), fault);
        assertTrue(fault.contains(" | line 4: cannot find symbol; symbol:   method sonar(int)"), fault);
        assertTrue(fault.contains(" | line 5: cannot find symbol; symbol:   variable x"), fault);
    }

    @Test
    void aFileMayUseAnotherAndIsCompiledAnewWithIt() throws IOException {
        Files.writeString(folder.resolve("Speeds.java"), "class Speeds { static final double AHEAD = 0.5; }");
        write("Ahead", "        return new Steering(Speeds.AHEAD, 0);");
        open();
        assertTrue(told.contains("loaded Ahead"), told.toString());
        told.clear();
        Files.writeString(folder.resolve("Speeds.java"), "class Speeds { static final double AHEAD = 0.125; }");
        opened.scan();
        assertTrue(told.contains("loaded Ahead"), told.toString());
    }

    @Test
    void anErrorIsReportedWithItsLineAndLeavesTheFormerVersion() throws IOException {
        write("Ahead", "        return new Steering(0.5, 0);");
        open();
        write("Ahead", "        return new Steering(0.5, 0)");
        opened.scan();
        String fault = "';' expected (look at the end of this line, or of the one before: something is missing)";
        assertEquals("failed Ahead 4 " + fault, told.get(1));
        assertEquals(List.of(new BehaviourList.Fault("Ahead", 4, fault)), list.faults());
        assertTrue(names().contains("Ahead"));
        write("Ahead", "        return new Steering(0.75, 0);");
        opened.scan();
        assertEquals(List.of(), list.faults());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Divide|int zero = 0; return new Steering(1 / zero, 0);|4|ArithmeticException: / by zero",
                "Infinite|return new Steering(1 / 0.0, 0);|4|IllegalArgumentException: a steering of Infinity m/s",
                "Nothing|return null;|4|decide returned null, expected a Steering",
                "Deep|return decide(senses);|4|StackOverflowError",
                "Endless|while (true) { }|4|no decision within 1 s: it computes",
                "Catches|for (;;) try { Math.sqrt(2); } catch (Exception e) { }|4|no decision within 1 s: it computes",
                "Sleeper|try { Thread.sleep(100000); } catch (Exception e) { } return null;|4|no decision within 1 s: it waits"
            })
    void whatItThrowsAndAnEndlessLoopEndItWithLineAndMessage(String name, String decide, int line, String text)
            throws IOException {
        write(name, decide);
        open();
        assertEquals("loaded " + name, told.get(0), told.toString());
        begin(name);
        runUntilItEnds();
        assertTrue(ends.get(0).startsWith(name + " Failed[line=" + line + ", text=" + text), ends.get(0));
        simulation.run(300);
        assertEquals(RobotStatus.STOPPED, robot.status());
        assertFalse(robot.autonomy().isActive());
    }

    @Test
    void whileOneProcessLoopsTheOthersDrive() throws IOException {
        write("Endless", "        while (true) { }");
        open();
        SimulatedRobot other = simulation.addRobot("other", new Position(0, 3), 0);
        other.autonomy().begin(BehaviourKind.WANDER);
        begin("Endless");
        runUntilItEnds();
        assertTrue(other.xMeters() > 0);
        assertEquals(0, robot.xMeters());
    }

    @Test
    void aProcessThatIsDoneEndsWhenTheRobotStands() throws IOException {
        Files.writeString(
                folder.resolve("Meter.java"),
                "import simrobot.behaviour.*;\n"
                        + "class Meter implements Behaviour {\n"
                        + "    private boolean done;\n"
                        + "    public Steering decide(Senses senses) {\n"
                        + "        done = senses.xMeters() > 1;\n"
                        + "        return new Steering(0.5, 0);\n"
                        + "    }\n"
                        + "    public boolean isDone() { return done; }\n"
                        + "}\n");
        open();
        begin("Meter");
        runUntilItEnds();
        assertEquals(List.of("Meter Done"), ends);
        assertEquals(RobotStatus.STOPPED, robot.status());
        assertEquals(1, robot.xMeters(), 0.6);
    }

    @Test
    void aProcessThatPushesOnAfterACollisionEndsBlocked() throws IOException {
        write("Ahead", "        return new Steering(0.5, 0);");
        open();
        simulation.addRobot("wall", new Position(1, 0), 0);
        begin("Ahead");
        runUntilItEnds();
        assertEquals(List.of("Ahead Collided[]"), ends);
        assertEquals(RobotStatus.COLLISION, robot.status());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "class Other { }|no class that is a process",
                "import simrobot.behaviour.*; abstract class Empty implements Behaviour { }|no class that is a process",
                "interface Empty extends simrobot.behaviour.Behaviour { }|no class that is a process",
                "import simrobot.behaviour.*; class Empty implements Behaviour { Empty(int n) { }"
                        + " public Steering decide(Senses s) { return null; } }|no class that is a process"
            })
    void aFileWithoutAProcessSaysWhatIsExpected(String text, String start) throws IOException {
        Files.writeString(folder.resolve("Empty.java"), text);
        open();
        assertTrue(told.get(0).startsWith("failed Empty 1 " + start), told.toString());
    }

    @Test
    void aJarNamesItsProcessesAsServices() throws IOException, SourceException {
        write("Ahead", "        return new Steering(0.5, 0);");
        Path file = folder.resolve("Ahead.java");
        Map<String, byte[]> classes = new BehaviourCompiler(ToolProvider.getSystemJavaCompiler(), SETTINGS.hints())
                .compile(file, Files.readString(file));
        Files.delete(folder.resolve("Ahead.java"));
        try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(folder.resolve("ours.jar")))) {
            jar.putNextEntry(new JarEntry("Ahead.class"));
            jar.write(classes.get("Ahead"));
            jar.putNextEntry(new JarEntry("META-INF/services/simrobot.behaviour.Behaviour"));
            jar.write("Ahead\n".getBytes(java.nio.charset.StandardCharsets.US_ASCII));
        }
        open();
        assertEquals(List.of("loaded Ahead"), told);
        begin("ahead");
        simulation.run(300);
        assertTrue(robot.xMeters() > 0.5);
    }

    @Test
    void aJarThatNamesNoneAndOneThatIsNoneSayWhatIsExpected() throws IOException {
        Files.writeString(folder.resolve("text.jar"), "no jar");
        open();
        assertEquals(1, told.size());
        assertTrue(told.get(0).startsWith("failed text 0 names no process, expected META-INF/services"), told.get(0));
    }

    @Test
    void aJavaWithoutACompilerSaysSo() throws IOException {
        write("Ahead", "        return new Steering(0.5, 0);");
        new BehaviourFolder(folder, list, listener, SETTINGS, null, file -> true);
        assertTrue(told.get(0).startsWith("failed Ahead 0 this Java has no compiler, expected a JDK"), told.get(0));
    }

    @ParameterizedTest
    @CsvSource({"wander", "none"})
    void aNameThatABuiltInProcessHasIsTakenAlsoAtTheNextLook(String name) throws IOException {
        String fault = "failed " + name + " 0 the name " + name + " is taken, expected a class of another name";
        write(name, "        return new Steering(0.5, 0);");
        open();
        assertEquals(List.of(fault), told);
        write("Ahead", "        return new Steering(0.5, 0);");
        opened.scan();
        assertEquals(List.of(fault, "loaded Ahead", fault), told);
        assertEquals(List.of("wander", "wall-follow", "Ahead"), names());
    }

    @Test
    void aFileThatTheCompilerFailsAtIsAFaultAndTheNextFileIsLoaded() throws IOException {
        JavaCompiler real = ToolProvider.getSystemJavaCompiler();
        AtomicInteger files = new AtomicInteger();
        JavaCompiler failing = (JavaCompiler) Proxy.newProxyInstance(
                getClass().getClassLoader(), new Class<?>[] {JavaCompiler.class}, (proxy, method, arguments) -> {
                    if (method.getName().equals("getStandardFileManager") && files.incrementAndGet() == 1) {
                        throw new IllegalStateException("no file");
                    }
                    return method.invoke(real, arguments);
                });
        write("Ahead", "        return new Steering(0.5, 0);");
        write("Back", "        return new Steering(-0.5, 0);");
        new BehaviourFolder(folder, list, listener, SETTINGS, failing, file -> true);
        assertEquals(List.of("failed Ahead 0 cannot be loaded: IllegalStateException: no file", "loaded Back"), told);
    }

    @Test
    void aFolderThatIsNoneIsRefused() {
        assertThrows(NotDirectoryException.class, () -> open(folder.resolve("nowhere"), list, listener));
    }

    @Test
    void theOthersOfAFileGoOnInANewChildWhenOneEndsIt() throws IOException {
        write(
                "Halts",
                "        if (senses.yMeters() < 1) Runtime.getRuntime().halt(0);\n        return new Steering(0.5, 0);");
        open();
        SimulatedRobot other = simulation.addRobot("other", new Position(0, 3), 0);
        assertTrue(other.autonomy().begin(list.of("Halts")));
        simulation.run(100);
        double before = other.xMeters();
        begin("Halts");
        runUntilItEnds();
        simulation.run(200);
        assertTrue(
                ends.get(0).startsWith("Halts Failed[line=4, text=it has ended its process, exit status 0"),
                ends.get(0));
        assertTrue(before > 0 && other.xMeters() > before + 0.5, before + " " + other.xMeters());
    }

    @Test
    void theProcessOfAFileThatIsDeletedEnds() throws IOException {
        write("Ahead", "        return new Steering(0.5, 0);");
        open();
        begin("Ahead");
        simulation.run(100);
        Files.delete(folder.resolve("Ahead.java"));
        opened.scan();
        runUntilItEnds();
        assertTrue(
                ends.get(0).startsWith("Ahead Failed[line=0, text=the file is not in the folder any more"),
                ends.get(0));
    }

    @Test
    void aPythonProgramDrivesAndItsFaultHasALine() throws IOException {
        Assumptions.assumeTrue(hasPython(), "no python3");
        Files.writeString(
                folder.resolve("Snake.py"),
                String.join(
                        "\n",
                        "import sys",
                        "for line in sys.stdin:",
                        "    word, *pairs = line.split()",
                        "    if word == 'decide':",
                        "        senses = dict(pair.split('=') for pair in pairs)",
                        "        speed = 1 / (1 - int(float(senses['x'])))",
                        "        print(f\"go robot={senses['robot']} speed={speed} turn=0\")"));
        open();
        begin("Snake");
        runUntilItEnds();
        assertTrue(robot.xMeters() > 1, "x " + robot.xMeters());
        assertTrue(
                ends.get(0).startsWith("Snake Failed[line=6, text=ZeroDivisionError: division by zero ("), ends.get(0));
    }

    @Test
    void aPythonProgramHearsTheKeysAndRequestsWhatAJavaOneMay() throws IOException {
        Assumptions.assumeTrue(hasPython(), "no python3");
        Files.writeString(folder.resolve("Stick.py"), """
                import sys
                for line in sys.stdin:
                    word, *pairs = line.split()
                    senses = dict(pair.split("=") for pair in pairs)
                    if word == "decide":
                        robot = "robot=" + senses["robot"]
                        if "7" in senses["pressed"]:
                            print("sms", robot, "to=" + senses["caller"], "text=key+7+%C3%B1")
                            print("mark", robot, "x=0 y=0", "toX=" + senses["odometryX"], "toY=1 text=")
                            print("a print")
                        print("keys", robot)
                        print("go", robot, "speed=0 turn=0 done=" + ("1" if "9" in senses["pressed"] else "0"))
                """);
        open();
        List<String> asked = new ArrayList<>();
        robot.autonomy().addRequestListener((kind, request) -> asked.add(request.toString()));
        begin("Stick");
        robot.autonomy().call().begin("5550100");
        runUntil(() -> robot.autonomy().takesKeys());
        asked.clear();
        robot.autonomy().call().press('7');
        runUntil(() -> robot.autonomy().marks().size() == 1);
        robot.autonomy().call().press('9');
        runUntilItEnds();
        assertEquals(
                List.of(
                        "Sms[to=5550100, text=key 7 ñ]",
                        "Mark[x=0.0, y=0.0, toX=0.0, toY=1.0, text=]",
                        "Printed[text=a print\n]"),
                asked.stream().filter(each -> !each.equals("Keys[]")).toList());
    }

    @Test
    void aPythonDecisionThatCannotBeReadIsNamed() throws IOException {
        Assumptions.assumeTrue(hasPython(), "no python3");
        Files.writeString(folder.resolve("Mute.py"), """
                import sys
                for line in sys.stdin:
                    if line.startswith("decide"):
                        print("go")
                        print("go robot=robot speed=0.2 turn=0")
                """);
        open();
        begin("Mute");
        runUntilItEnds();
        assertTrue(
                ends.get(0)
                        .startsWith("Mute Failed[line=0, text=expected go robot=1 speed=NUMBER turn=NUMBER,"
                                + " found go robot=robot speed=0.2 turn=0"),
                ends.get(0));
    }

    private static boolean hasPython() {
        return Stream.of(System.getenv("PATH").split(File.pathSeparator))
                .anyMatch(path -> Files.isExecutable(Path.of(path, "python3")));
    }

    /** As when SimRobot is killed: the pipe's end is all that a child sees of it. */
    @ParameterizedTest
    @ValueSource(strings = {"return Steering.STOP;", "while (true) {}"})
    void aChildEndsWithThePipeToSimRobot(String decide) throws Exception {
        write("Orphan", decide);
        String source = Files.readString(folder.resolve("Orphan.java"));
        Map<String, byte[]> classes = new BehaviourCompiler(ToolProvider.getSystemJavaCompiler(), SETTINGS.hints())
                .compile(folder.resolve("Orphan.java"), source);
        ChildFile file = ChildFile.ofSource("Orphan", classes, SourceLines.of(source), SETTINGS);
        Process child = new ProcessBuilder(file.command()).start();
        try (Writer pipe = child.outputWriter()) {
            pipe.write(String.join("\n", file.lines()) + "\nbegin robot=1 class=Orphan\ndecide robot=1\n");
        }
        child.waitFor();
    }

    @Test
    void aProgramThatIsNotThereIsNamed() {
        IOException missing = assertThrows(IOException.class, () -> new ChildProcess("X", List.of("python9"), null));
        assertEquals("cannot be started: expected the program python9", missing.getMessage());
    }

    @Test
    void aPythonFileWithABlankInItsNameIsRefused() throws IOException {
        Files.writeString(folder.resolve("my robot.py"), "");
        open();
        assertEquals(
                List.of("failed my robot 0 expected a file name of letters, digits and _, found my robot.py"), told);
    }

    @Test
    void aMalformedLineOfAChildIsNone() {
        assertEquals(Optional.empty(), PipeLine.parse("go robot=%"));
        assertEquals(1e+20, PipeLine.parse("go speed=1e+20").orElseThrow().number("speed"));
    }
}
