package simrobot.source;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.ResourceBundle;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simrobot.process.BehaviourList;
import simrobot.process.Decision;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.source.child.ChildMain;
import simrobot.world.Position;
import simrobot.world.World;

/** Mistakes that beginners make, all in one folder: each is told with its line and a hint, while another process drives on. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class MistakesOfStudentsTest {
    private static final String HEAD = "import simrobot.behaviour.*;\n";

    /**
     * A file and its fault.
     *
     * @param cause the key of its hint
     */
    private record Mistake(String name, String source, int line, String text, String cause) {
        @Override
        public String toString() {
            return name;
        }
    }

    private final Simulation simulation = new Simulation(World.bare(), 1);
    private final SimulatedRobot robot = simulation.addRobot("robot", new Position(0, 0), 0);
    private final SimulatedRobot other = simulation.addRobot("other", new Position(0, 5), 0);
    private final List<Decision.End> ends = new ArrayList<>();
    private final Map<String, BehaviourList.Fault> faults = new HashMap<>();
    private BehaviourFolder opened;

    private static Mistake whole(String name, int line, String text, String cause, String... lines) {
        return new Mistake(name, HEAD + String.join("\n", lines) + "\n", line, text, cause);
    }

    /** @param decide the lines of the method: the first is line 4 of the file */
    private static Mistake inDecide(String name, int line, String text, String cause, String... decide) {
        String method =
                "    public Steering decide(Senses senses) {\n        " + String.join("\n        ", decide) + "\n    }";
        return whole(name, line, text, cause, "public class " + name + " implements Behaviour {", method, "}");
    }

    static Stream<Mistake> mistakes() {
        return Stream.of(ofCompiler(), ofDecision(), ofRuntime(), endless()).flatMap(each -> each);
    }

    private static Stream<Mistake> ofCompiler() {
        return Stream.of(
                inDecide(
                        "Brace",
                        4,
                        "reached end of file",
                        "premature.eof",
                        "if (senses.isBlocked()) {",
                        "return null;"),
                inDecide("Misspelt", 4, "cannot find symbol", "cant.resolve.location", "return Sterring.STOP;"),
                new Mistake(
                        "NoImport",
                        "public class NoImport implements Behaviour {}\n",
                        1,
                        "symbol: class Behaviour",
                        "doesnt.exist"),
                inDecide("Kind", 4, "incompatible types", "prob.found.req", "return 0.3;"),
                inDecide("Semicolon", 4, "';' expected", "expected", "return Steering.STOP"),
                inDecide("Returns", 5, "missing return", "missing.ret.stmt", "if (senses.isBlocked()) return null;"),
                whole("Named", 2, "class Other is public", "class.public.should.be.in.file", "public class Other {}"),
                whole("Plain", 2, "no class that is a process", "process", "public class Plain {}"),
                whole(
                        "Parameter",
                        2,
                        "no class that is a process",
                        "process",
                        "public class Parameter implements Behaviour {",
                        "    Parameter(int n) {}",
                        "    public Steering decide(Senses senses) { return Steering.STOP; }",
                        "}"));
    }

    private static Stream<Mistake> ofDecision() {
        return Stream.of(
                whole(
                        "Constructor",
                        3,
                        "IllegalStateException: early",
                        "",
                        "public class Constructor implements Behaviour {",
                        "    public Constructor() { throw new IllegalStateException(\"early\"); }",
                        "    public Steering decide(Senses senses) { return Steering.STOP; }",
                        "}"),
                whole(
                        "Static",
                        3,
                        "NegativeArraySizeException: -1",
                        "NegativeArraySizeException",
                        "public class Static implements Behaviour {",
                        "    static int[] all = new int[-1];",
                        "    public Steering decide(Senses senses) { return Steering.STOP; }",
                        "}"),
                inDecide("Nothing", 4, "decide returned null", "null", "return null;"),
                inDecide(
                        "Root",
                        4,
                        "a steering of NaN",
                        "IllegalArgumentException",
                        "return new Steering(Math.sqrt(-1), 0);"),
                inDecide(
                        "Division",
                        5,
                        "/ by zero",
                        "ArithmeticException",
                        "int zero = 0;",
                        "return new Steering(1 / zero, 0);"),
                inDecide(
                        "Index",
                        4,
                        "Index 3 out of bounds",
                        "ArrayIndexOutOfBoundsException",
                        "return new Steering(new double[] {1, 2, 3}[3], 0);"),
                inDecide("Recursion", 4, "StackOverflowError", "StackOverflowError", "return decide(senses);"),
                inDecide(
                        "Eater",
                        5,
                        "OutOfMemoryError",
                        "OutOfMemoryError",
                        "var all = new java.util.ArrayList<byte[]>();",
                        "while (true) all.add(new byte[10_000_000]);"),
                inDecide(
                        "Keyboard",
                        4,
                        "a process has no keyboard",
                        "",
                        "return new Steering(new java.util.Scanner(System.in).nextDouble(), 0);"));
    }

    private static Stream<Mistake> ofRuntime() {
        return Stream.of(
                inDecide("Exit", 4, "System.exit is called", "exit", "if (true) System.exit(0);", "return null;"),
                inDecide("Halt", 4, "exit status 3", "halt", "Runtime.getRuntime().halt(3);", "return Steering.STOP;"),
                inDecide(
                        "Spinner",
                        4,
                        "a thread of its own still runs",
                        "thread",
                        "new Thread(() -> { while (true) {} }).start();",
                        "return Steering.STOP;"),
                inDecide(
                        "Daemons",
                        4,
                        "a thread of its own still runs",
                        "thread",
                        "var t = new Thread(() -> { while (true) Thread.onSpinWait(); });",
                        "t.setDaemon(true);",
                        "t.start();",
                        "return Steering.STOP;"));
    }

    private static Stream<Mistake> endless() {
        String late = "no decision within 1 s: it computes";
        String waits = "no decision within 1 s: it waits";
        return Stream.of(
                inDecide("Loop", 4, late, "loops", "while (true) {}"),
                inDecide(
                        "Fibonacci",
                        6,
                        late,
                        "loops",
                        "return new Steering(fib(60), 0);",
                        "} int fib(int n) {",
                        "return n < 2 ? n : fib(n - 1) + fib(n - 2);"),
                inDecide(
                        "Streams",
                        4,
                        late,
                        "loops",
                        "return new Steering(java.util.stream.LongStream.iterate(0, i -> i + 1).filter(i -> i < 0).count(), 0);"),
                inDecide("Printer", 4, late, "loops", "while (true) System.out.println(senses);"),
                inDecide(
                        "Parallel",
                        4,
                        "no decision within 1 s",
                        "",
                        "return new Steering(java.util.stream.LongStream.range(0, Long.MAX_VALUE).parallel().filter(i -> i < 0).count(), 0);"),
                inDecide(
                        "Sleeper",
                        4,
                        waits,
                        "waits",
                        "try { Thread.sleep(10_000); } catch (InterruptedException e) {}",
                        "return Steering.STOP;"),
                inDecide(
                        "Waiter",
                        4,
                        waits,
                        "waits",
                        "synchronized (this) { try { wait(); } catch (InterruptedException e) {} }",
                        "return Steering.STOP;"));
    }

    @BeforeAll
    void load(@TempDir Path folder) throws IOException {
        for (Mistake mistake : mistakes().toList()) {
            Files.writeString(folder.resolve(mistake.name() + ".java"), mistake.source());
        }
        Files.writeString(
                folder.resolve("Good.java"),
                inDecide("Good", 0, "", "", "return new Steering(0.5, 1);").source());
        opened = new BehaviourFolder(
                folder,
                simulation.behaviours(),
                new BehaviourFolder.Listener() {
                    @Override
                    public void failed(String name, int line, String text) {
                        faults.put(name, new BehaviourList.Fault(name, line, text));
                    }
                },
                BehaviourFolderTest.SETTINGS,
                ToolProvider.getSystemJavaCompiler(),
                file -> true);
        opened.waitForDecisions();
        robot.autonomy().addEndListener((kind, how) -> ends.add(how));
        assertTrue(other.autonomy().begin(simulation.behaviours().of("Good")));
    }

    @AfterAll
    void nothingIsLeftWhenTheFolderIsClosed() {
        List<ProcessHandle> children = children();
        opened.close();
        children.forEach(child -> child.onExit().join());
        assertEquals(List.of(), children());
    }

    private static List<ProcessHandle> children() {
        return ProcessHandle.current()
                .children()
                .filter(child -> child.info().commandLine().orElse("").contains(ChildMain.class.getName()))
                .toList();
    }

    @ParameterizedTest
    @MethodSource("mistakes")
    void eachIsToldWithItsLineAndAHintWhileAnotherProcessDrives(Mistake mistake) {
        ends.clear();
        double heading = other.headingRadians();
        if (!faults.containsKey(mistake.name())) {
            assertTrue(robot.autonomy().begin(simulation.behaviours().of(mistake.name())));
            while (ends.isEmpty()) {
                simulation.run(10);
            }
            Decision.Failed failed = (Decision.Failed) ends.get(0);
            faults.put(mistake.name(), new BehaviourList.Fault(mistake.name(), failed.line(), failed.text()));
            assertTrue(other.headingRadians() != heading && other.autonomy().isUnfinished());
        }
        BehaviourList.Fault fault = faults.get(mistake.name());
        assertEquals(mistake.line(), fault.line(), fault.text());
        assertTrue(fault.text().contains(mistake.text()), fault.text());
        if (!mistake.cause().isEmpty()) {
            String hint = ResourceBundle.getBundle("simrobot.source.hints", Locale.ENGLISH)
                    .getString(mistake.cause());
            assertTrue(fault.text().contains(hint), fault.text());
        }
    }

    @Test
    void everyHintExistsInSpanish() {
        ResourceBundle english = ResourceBundle.getBundle("simrobot.source.hints", Locale.ROOT);
        ResourceBundle spanish = ResourceBundle.getBundle("simrobot.source.hints", Locale.forLanguageTag("es"));
        assertEquals(english.keySet(), spanish.keySet());
        english.keySet().forEach(key -> assertTrue(!english.getString(key).equals(spanish.getString(key)), key));
    }
}
