package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A recorded session is replayed with the same events. */
class ReplayTest {
    @TempDir
    Path folder;

    private static FinishedProgram replay(Path file, String... options) throws Exception {
        List<String> arguments = new ArrayList<>(List.of("--headless", "--replay", file.toString()));
        arguments.addAll(List.of(options));
        return FinishedProgram.run("simrobot", arguments.toArray(String[]::new));
    }

    private static List<ConsoleEvent> events(String output) {
        return output.lines().map(ConsoleEvent::parse).toList();
    }

    @Test
    void aCallWithOrdersACollisionAndAProcessIsReplayedWordForWord() throws Exception {
        Path file = folder.resolve("session.rec");
        List<ConsoleEvent> poses = new ArrayList<>();
        try (Scenario scenario = new Scenario("a recorded session")) {
            scenario.center();
            RunningProgram robot = scenario.robot("corridor.map", "--speed", "20", "--record", file.toString());
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press ** #**20 **");
            phone.expect("tone", "key", "3");
            poses.add(robot.ask("pose", "pose"));
            phone.say("press ** #**9999 **");
            phone.expect("tone", "key", "4");
            poses.add(robot.ask("pose", "pose"));
            phone.say("hangup");
            robot.expect("released");
            robot.say("behaviour wander");
            robot.expect("status", "value", "Moving");
            poses.add(robot.ask("pose", "pose"));
            assertEquals(0, robot.quit());
        }
        FinishedProgram told = replay(file);
        assertEquals(0, told.status(), told.error());
        List<ConsoleEvent> events = events(told.output());
        assertEquals("ready", events.get(0).name());
        List<ConsoleEvent> toldPoses =
                events.stream().filter(event -> event.name().equals("pose")).toList();
        assertTrue(toldPoses.containsAll(poses), poses + " in " + toldPoses);
        List<String> names = events.stream().map(ConsoleEvent::name).toList();
        assertTrue(
                names.containsAll(List.of(
                        "registered", "call", "keys", "order", "outcome", "tone", "status", "released", "behaviour")),
                names.toString());
        assertEquals(told.output(), replay(file, "--speed", "1000").output());
    }

    @Test
    void aKilledProgramLeavesARecordingOfAllButTheLastMoments() throws Exception {
        Path file = folder.resolve("killed.rec");
        try (Scenario scenario = new Scenario("killed while recording")) {
            RunningProgram robot = scenario.start(
                    "robot",
                    "simrobot",
                    "--headless",
                    "--no-sound",
                    "--center",
                    "127.0.0.1:1",
                    "--world",
                    Scenario.world("office.map").toString(),
                    "--behaviour",
                    "wander",
                    "--record",
                    file.toString());
            robot.expect("ready");
            ConsoleEvent pose = robot.ask("pose", "pose");
            // the file grows as the pose reaches it
            String line = "pose robot=robot x=" + pose.field("x");
            for (int look = 0; !replay(file).output().contains(line); look++) {
                assertTrue(look < 100, "the recording does not grow");
                robot.ask("status", "status");
            }
            robot.kill();
        }
        FinishedProgram told = replay(file);
        assertEquals(0, told.status(), told.error());
        assertTrue(told.output().startsWith("ready robots=robot\n"), told.output());
    }

    private Path run(String name, String seed) throws Exception {
        return run(name, seed, "wall-follow");
    }

    private Path run(String name, String seed, String behaviour) throws Exception {
        Path file = folder.resolve(name);
        FinishedProgram run = FinishedProgram.run(
                "simrobot",
                "--run",
                "30",
                "--behaviour",
                behaviour,
                "--noise",
                "1",
                "--seed",
                seed,
                "--robots",
                "all",
                "--world",
                Scenario.world("office.map").toString(),
                "--record",
                file.toString());
        assertEquals(1, run.status(), run.error());
        return file;
    }

    @Test
    void aSeedGivesTheSameRecordingToTheLastOctet() throws Exception {
        Path first = run("first.rec", "5");
        assertEquals(-1, Files.mismatch(first, run("again.rec", "5")));
        assertTrue(Files.mismatch(first, run("other.rec", "6")) >= 0);
    }

    @Test
    void aRunOfWanderersIsRecordedToo() throws Exception {
        Path first = run("first.rec", "5", "wander");
        assertEquals(-1, Files.mismatch(first, run("again.rec", "5", "wander")));
        FinishedProgram told = replay(first);
        assertEquals(0, told.status(), told.error());
        assertTrue(told.output().contains("behaviour robot=Corridor value=wander\n"), told.output());
        assertTrue(told.output().contains("status robot=Library value=Moving\n"), told.output());
    }

    @Test
    void whatIsNoRecordingOrADamagedOneIsSaid() throws Exception {
        Path file = folder.resolve("run.rec");
        FinishedProgram run = FinishedProgram.run(
                "simrobot",
                "--run",
                "120",
                "--behaviour",
                "wall-follow",
                "--world",
                Scenario.world("office.map").toString(),
                "--record",
                file.toString());
        assertEquals(1, run.status(), run.error());
        byte[] whole = Files.readAllBytes(file);
        byte[] damaged = whole.clone();
        damaged[whole.length - 100] ^= 1;
        Files.write(file, damaged);
        assertRefused(file, "checksum");
        Files.write(file, Arrays.copyOf(whole, whole.length - 100));
        FinishedProgram torn = replay(file);
        assertEquals(0, torn.status());
        assertTrue(torn.error().contains("the end is missing"), torn.error());
        Files.writeString(file, "2D-Map\nLINES\nDATA\n", StandardCharsets.UTF_8);
        assertRefused(file, "no SimRobot recording");
        assertRefused(folder.resolve("nowhere.rec"), "no such file");
    }

    private static void assertRefused(Path file, String words) throws Exception {
        FinishedProgram refused = replay(file);
        assertEquals(74, refused.status(), refused.error());
        assertTrue(refused.error().contains(words), refused.error());
        assertTrue(refused.error().contains(file.toString()), refused.error());
    }
}
