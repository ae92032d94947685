package simrobot.app.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.console.ExitStatus;
import simgsm.console.UsageException;
import simgsm.speech.AudioOutput;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simrobot.app.BrokenPipe;
import simrobot.app.SimRobotOptions;
import simrobot.control.Fleet;
import simrobot.control.RobotName;
import simrobot.control.SimRobot;
import simrobot.process.BehaviourKind;
import simrobot.replay.Recording;
import simrobot.replay.ReplayCursor;
import simrobot.robot.RobotState;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.VeriCommandSettings;

/** {@code --run} simulates what the window shows. */
class BatchRunTest {
    private static final int SECONDS = 20;
    private static final World ROOM = World.of(
            "room",
            List.of(
                    new Segment(-4, -3, 4, -3),
                    new Segment(4, -3, 4, 3),
                    new Segment(4, 3, -4, 3),
                    new Segment(-4, 3, -4, -3)));

    @TempDir
    Path folder;

    private static List<RobotState> states(List<SimulatedRobot> robots) {
        return robots.stream().map(SimulatedRobot::state).toList();
    }

    /** The state of all robots at each second of a session that was set up as windows and consoles do. */
    private static List<List<RobotState>> live(BehaviourKind behaviour) throws IOException, UsageException {
        Simulation simulation = new Simulation(ROOM, 7);
        simulation.setNoise(1);
        VeriCommandSettings settings =
                new VeriCommandSettings(Locale.ENGLISH, Set.of(), VeriCommandSettings.OnHangup.STOP);
        Fleet.Kit kit = new Fleet.Kit(
                7,
                true,
                true,
                behaviour,
                SpeechCodec.Kind.A_LAW,
                1500,
                Optional.empty(),
                Optional.empty(),
                name -> CallAudioListener.NONE,
                number -> Optional.empty());
        List<List<RobotState>> states = new ArrayList<>();
        try (SimRobot simRobot =
                new SimRobot(simulation, new InetSocketAddress("127.0.0.1", 1), settings, AudioOutput.SILENT)) {
            Fleet fleet = new Fleet(simRobot, kit);
            for (String robot : List.of("anna=5550201", "berta=5550202", "clara=5550203")) {
                fleet.addFirst(RobotName.parse(robot), simulation, Optional.empty());
            }
            for (int second = 0; second < SECONDS; second++) {
                simulation.run(100);
                states.add(states(simulation.robots()));
            }
        }
        return states;
    }

    private List<List<RobotState>> run(BehaviourKind behaviour) throws IOException, UsageException {
        Path file = folder.resolve("run.rec");
        BatchRun.run(
                SimRobotOptions.all()
                        .parse(List.of(
                                "--run=" + SECONDS,
                                "--seed=7",
                                "--noise=1",
                                "--robot=anna=5550201",
                                "--robot=berta=5550202",
                                "--robot=clara=5550203",
                                "--behaviour=" + behaviour.text(),
                                "--record=" + file)),
                ROOM);
        List<List<RobotState>> states = new ArrayList<>();
        try (Recording recording = Recording.open(file)) {
            ReplayCursor cursor = new ReplayCursor(recording);
            for (int second = 1; second <= SECONDS; second++) {
                cursor.seek(second * 1_000_000_000L);
                states.add(states(cursor.robots()));
            }
        }
        return states;
    }

    @ParameterizedTest
    @ValueSource(strings = {"wander", "wall-follow", "none"})
    void theSameSeedGivesTheSameStatesToTheLastBitAsInAWindow(String behaviour) throws Exception {
        BehaviourKind kind = BehaviourKind.ofText(behaviour);
        assertEquals(live(kind), run(kind));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--pioneer=127.0.0.1:1", "--http=0", "--p2os=0", "--at=0", "--modem=127.0.0.1:1"})
    void anOptionThatNeedsAPeerIsRefused(String option) {
        UsageException refused = assertThrows(
                UsageException.class,
                () -> BatchRun.run(SimRobotOptions.all().parse(List.of("--run=1", option)), ROOM));
        String name = option.substring(0, option.indexOf('='));
        assertEquals(name + ": a run (--run) has no clients, expected one of the two", refused.getMessage());
    }

    @Test
    void theThreadsOfStudentsProcessesEndWithEachOfSeveralRuns() throws Exception {
        save("Mine", "");
        BatchRun.run(SimRobotOptions.all().parse(options("Mine", "--run=0.5", "--runs=3")), ROOM);
        assertNoThreads("behaviour Mine");
    }

    @Test
    void theThreadsAndTheRecordEndWhenTheTrackCannotBeWritten() throws Exception {
        save("Untracked", "");
        Path record = folder.resolve("untracked.rec");
        assertThrows(
                IOException.class,
                () -> BatchRun.run(
                        SimRobotOptions.all()
                                .parse(options(
                                        "Untracked",
                                        "--run=0.5",
                                        "--record=" + record,
                                        "--track=" + folder.resolve("nowhere/track.csv"))),
                        ROOM));
        assertNoThreads("behaviour Untracked");
        try (Recording recording = Recording.open(record)) {
            assertEquals(1, new ReplayCursor(recording).robots().size());
        }
    }

    @Test
    void aRunWhoseRecordCouldNotBeWrittenFails() throws Exception {
        try (BrokenPipe pipe = new BrokenPipe(folder.resolve("run.rec"))) {
            pipe.breakOff();
            List<String> options = List.of("--run=600", "--behaviour=wander", "--record=" + pipe.path());
            IOException failure = assertThrows(
                    IOException.class, () -> BatchRun.run(SimRobotOptions.all().parse(options), ROOM));
            assertTrue(failure.getMessage().startsWith(pipe.path() + ": "), failure.getMessage());
        }
    }

    @Test
    void aDecisionThatTakesLongerThanAStepOfTheClockChangesNoPose() throws Exception {
        save("Quick", "");
        save("Slow", "try { Thread.sleep(70); } catch (InterruptedException e) { return null; }");
        assertEquals(track("Quick"), track("Slow"));
    }

    private List<String> track(String behaviour) throws Exception {
        Path file = folder.resolve(behaviour + ".csv");
        BatchRun.run(SimRobotOptions.all().parse(options(behaviour, "--run=0.5", "--track=" + file)), ROOM);
        return Files.readAllLines(file);
    }

    private List<String> options(String behaviour, String... more) {
        List<String> options =
                new ArrayList<>(List.of("--robot=anna=5550201", "--behaviours=" + folder, "--behaviour=" + behaviour));
        options.addAll(List.of(more));
        return options;
    }

    private void save(String name, String statements) throws IOException {
        Files.writeString(
                folder.resolve(name + ".java"),
                "import simrobot.behaviour.*;\n"
                        + "public class " + name + " implements Behaviour {\n"
                        + "    public Steering decide(Senses senses) {\n" + statements + "\n"
                        + "        return new Steering(0.5, 0.1);\n"
                        + "    }\n"
                        + "}\n");
    }

    private static void assertNoThreads(String name) throws InterruptedException {
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().startsWith(name)) {
                thread.join(TimeUnit.SECONDS.toMillis(20));
                assertFalse(thread.isAlive(), thread.getName());
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"--limit=600", "--runs=2"})
    void aFileThatHaltsFailsAndDoesNotEndTheProgram(String option) throws Exception {
        save("Halts", "Runtime.getRuntime().halt(0);");
        assertEquals(
                ExitStatus.FAILED,
                BatchRun.run(SimRobotOptions.all().parse(options("Halts", "--run=done", option)), ROOM));
    }
}
