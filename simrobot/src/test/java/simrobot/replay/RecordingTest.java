package simrobot.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Executor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.console.Event;
import simrobot.process.BehaviourKind;
import simrobot.robot.RobotState;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.Instruction;

/** Sessions that are recorded and read again: the same to the last bit, and what becomes of broken files. */
class RecordingTest {
    private static final World ROOM = World.of(
            "room",
            List.of(
                    new Segment(0, 0, 8, 0),
                    new Segment(8, 0, 8, 6),
                    new Segment(8, 6, 0, 6),
                    new Segment(0, 6, 0, 0)));

    @TempDir
    Path folder;

    /** Drops the request to flush; records are written when they are full, and at the end. */
    private static final Executor NEVER_FLUSHES = act -> {};

    private final List<List<RobotState>> states = new ArrayList<>();

    private Path file() {
        return folder.resolve("session.rec");
    }

    private static Simulation threeRobots() {
        Simulation simulation = new Simulation(ROOM, 7);
        for (int i = 0; i < 3; i++) {
            simulation.addRobot("r" + i, new Position(1.5 + 2 * i, 3), i);
        }
        return simulation;
    }

    private static List<RobotState> statesOf(List<SimulatedRobot> robots) {
        return robots.stream().map(SimulatedRobot::state).toList();
    }

    /** Robots that wander, stand, drive by order, collide, are dragged, come and go; acts by chance, every step noted. */
    private void record(Simulation simulation, int steps) throws IOException {
        Random chance = new Random(3);
        try (SessionRecorder recorder = SessionRecorder.open(file(), simulation, NEVER_FLUSHES)) {
            states.add(statesOf(simulation.robots()));
            for (int step = 1; step <= steps; step++) {
                if (chance.nextInt(200) == 0) {
                    act(simulation, chance, recorder, step);
                }
                simulation.step();
                states.add(statesOf(simulation.robots()));
            }
        }
    }

    private static void act(Simulation simulation, Random chance, SessionRecorder recorder, int step) {
        SimulatedRobot robot =
                simulation.robots().get(chance.nextInt(simulation.robots().size()));
        recorder.event(Event.of("order").with("robot", robot.name()).with("text", "act " + step));
        switch (chance.nextInt(8)) {
            case 0, 1 -> robot.autonomy().begin(BehaviourKind.WANDER);
            case 2 -> robot.autonomy().begin(BehaviourKind.WALL_FOLLOW);
            case 3 -> robot.brake();
            case 4 -> robot.place(1 + 6 * chance.nextDouble(), 1 + 4 * chance.nextDouble(), chance.nextDouble());
            case 5 -> {
                robot.brakeAtOnce();
                robot.setPower(true);
                robot.setMotors(true);
                if (robot.status() == vericommand.RobotStatus.STOPPED) {
                    robot.start(new Instruction.Forward(300), outcome -> {});
                }
            }
            case 6 -> robot.setMotors(chance.nextBoolean());
            default -> {
                if (step % 3 == 0) {
                    simulation.load(World.of("room " + step, ROOM.items(Segment.class)));
                } else if (simulation.robots().size() < 6) {
                    simulation.addRobot("late" + step);
                } else {
                    simulation.removeRobot(robot);
                }
            }
        }
    }

    @Test
    void everyStateOfALongSessionComesBackToTheLastBit() throws IOException {
        record(threeRobots(), 20_000);
        try (Recording recording = Recording.open(file())) {
            assertEquals(20_000 * Simulation.STEP_NANOS, recording.lastNanos());
            ReplayCursor cursor = new ReplayCursor(recording);
            for (int step = 0; step <= 20_000; step++) {
                assertEquals(states.get(step), statesOf(cursor.robots()), "step " + step);
                cursor.step();
            }
            assertTrue(cursor.isAtEnd());
        }
    }

    @Test
    void aJumpForwardOrBackShowsWhatWasThere() throws IOException {
        record(threeRobots(), 20_000);
        Random chance = new Random(5);
        try (Recording recording = Recording.open(file())) {
            ReplayCursor cursor = new ReplayCursor(recording);
            for (int jump = 0; jump < 200; jump++) {
                int step = chance.nextInt(20_001);
                cursor.seek(step * Simulation.STEP_NANOS + chance.nextInt((int) Simulation.STEP_NANOS));
                assertEquals(step * Simulation.STEP_NANOS, cursor.timeNanos());
                assertEquals(states.get(step), statesOf(cursor.robots()), "step " + step);
            }
        }
    }

    @Test
    void wheelsThatErrAreRecordedAsTheyErred() throws IOException {
        Simulation simulation = new Simulation(ROOM, 7);
        simulation.setNoise(2);
        simulation.addRobot("r", new Position(4, 3), 1).autonomy().begin(BehaviourKind.WANDER);
        record(simulation, 3_000);
        RobotState last = states.get(3_000).get(0);
        assertTrue(last.odometryHeadingRadians() != last.headingRadians() - 1);
        try (Recording recording = Recording.open(file())) {
            ReplayCursor cursor = new ReplayCursor(recording);
            cursor.seek(recording.lastNanos());
            assertEquals(states.get(3_000), statesOf(cursor.robots()));
        }
    }

    @Test
    void theWorldComesBackWhole() throws IOException {
        Simulation simulation = threeRobots();
        record(simulation, 10);
        try (Recording recording = Recording.open(file())) {
            assertEquals(
                    simulation.world(), new ReplayCursor(recording).snapshot().world());
        }
    }

    @Test
    void eventsAndMarkersKeepTheirOrderAndTime() throws IOException {
        Simulation simulation = threeRobots();
        List<Event> told = List.of(
                Event.of("call").with("robot", "r0").with("from", "5550100"),
                Event.of("order").with("robot", "r0").with("text", "** #**20 **"),
                Event.of("pose").with("robot", "r0"),
                Event.of("status").with("robot", "r0").with("value", "Collision"),
                Event.of("outcome").with("robot", "r0").with("tone", 4));
        try (SessionRecorder recorder = SessionRecorder.open(file(), simulation, NEVER_FLUSHES)) {
            for (Event event : told) {
                simulation.run(100);
                recorder.event(event);
            }
        }
        try (Recording recording = Recording.open(file())) {
            assertEquals(
                    told.stream().map(Event::toString).toList(),
                    recording.events().stream().map(RecordedEvent::line).toList());
            assertEquals(
                    List.of(1, 2, 4, 5),
                    recording.markers().stream()
                            .map(marker -> (int) (marker.timeNanos() / 1_000_000_000))
                            .toList());
            assertEquals(
                    List.of(
                            TimelineMarker.Kind.CALL,
                            TimelineMarker.Kind.ORDER,
                            TimelineMarker.Kind.COLLISION,
                            TimelineMarker.Kind.REPLY),
                    recording.markers().stream().map(TimelineMarker::kind).toList());
        }
    }

    @Test
    void anHourOfWanderingTakesAboutTwelveMegabytes() throws IOException {
        Simulation simulation = threeRobots();
        simulation.robots().forEach(robot -> robot.autonomy().begin(BehaviourKind.WANDER));
        SessionRecorder recorder = SessionRecorder.open(file(), simulation, NEVER_FLUSHES);
        simulation.run(6_000);
        recorder.close();
        long octetsPerRobotStep = Files.size(file()) / 3 / 6_000;
        assertTrue(octetsPerRobotStep < 36, "octets a robot and step: " + octetsPerRobotStep);
    }

    @Test
    void standingStillTakesNextToNothing() throws IOException {
        Simulation simulation = threeRobots();
        SessionRecorder recorder = SessionRecorder.open(file(), simulation, NEVER_FLUSHES);
        simulation.run(360_000);
        recorder.close();
        assertTrue(Files.size(file()) < 2_000, "octets " + Files.size(file()));
        try (Recording recording = Recording.open(file())) {
            assertEquals(3_600_000_000_000L, recording.lastNanos());
        }
    }

    @Test
    void aFileThatIsCutAnywhereIsReadAsFarAsItGoes() throws IOException {
        record(threeRobots(), 3_000);
        byte[] whole = Files.readAllBytes(file());
        int read = 0;
        for (int length = whole.length - 1; length > 0; length -= 997) {
            Files.write(file(), Arrays.copyOf(whole, length));
            try (Recording recording = Recording.open(file())) {
                ReplayCursor cursor = new ReplayCursor(recording);
                cursor.seek(recording.lastNanos());
                int step = (int) (cursor.timeNanos() / Simulation.STEP_NANOS);
                assertEquals(states.get(step), statesOf(cursor.robots()));
                assertTrue(recording.damage().isEmpty());
                read++;
            } catch (IOException nothingWhole) {
                assertTrue(length < 2_000, "length " + length + ": " + nothingWhole.getMessage());
            }
        }
        assertTrue(read > 3, "read " + read);
    }

    @Test
    void aFlippedBitIsNamedWithItsPlaceAndNothingBehindItIsRead() throws IOException {
        record(threeRobots(), 3_000);
        byte[] whole = Files.readAllBytes(file());
        for (int at = RecordingFormat.HEADER_OCTETS; at < whole.length; at += 331) {
            byte[] damaged = whole.clone();
            damaged[at] ^= 0x10;
            Files.write(file(), damaged);
            try (Recording recording = Recording.open(file())) {
                assertTrue(recording.damage().isPresent() || recording.isTorn(), "octet " + at);
                ReplayCursor cursor = new ReplayCursor(recording);
                cursor.seek(recording.lastNanos());
                int step = (int) (cursor.timeNanos() / Simulation.STEP_NANOS);
                assertEquals(states.get(step), statesOf(cursor.robots()), "octet " + at);
            } catch (IOException expected) {
                assertTrue(at < 1_000, "octet " + at + ": " + expected.getMessage());
            }
        }
    }

    @Test
    void foreignFilesAreRefusedByName() throws IOException {
        Files.writeString(file(), "2D-Map\nthis is a map and no recording\n", StandardCharsets.UTF_8);
        String message =
                assertThrows(IOException.class, () -> Recording.open(file())).getMessage();
        assertTrue(message.endsWith("session.rec: no SimRobot recording, expected a file made by --record"), message);
        Files.write(file(), new byte[0]);
        assertThrows(IOException.class, () -> Recording.open(file()));
        assertThrows(IOException.class, () -> Recording.open(folder));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3, 9})
    void anotherVersionIsRefusedByItsNumber(int version) throws IOException {
        record(threeRobots(), 10);
        byte[] whole = Files.readAllBytes(file());
        whole[RecordingFormat.MAGIC.length() + 1] = (byte) version;
        Files.write(file(), whole);
        String message =
                assertThrows(IOException.class, () -> Recording.open(file())).getMessage();
        assertTrue(message.contains("session.rec: a recording of version " + version + " "), message);
        assertTrue(message.contains("expected version 2"), message);
    }

    @Test
    void eventsAreWrittenWithEachFullRecordAndNotOnlyWhenNothingHappens() {
        Simulation simulation = threeRobots();
        simulation.robots().forEach(robot -> robot.autonomy().begin(BehaviourKind.WANDER));
        List<RecordingFormat.Kind> kinds = new ArrayList<>();
        SessionEncoder encoder = new SessionEncoder(simulation, (kind, begin, end, content) -> kinds.add(kind));
        encoder.event(Event.of("order").with("robot", "r0"));
        for (int atBeginning = kinds.size(); kinds.size() < atBeginning + 2; ) {
            simulation.step();
            encoder.step(simulation.timeNanos());
        }
        assertTrue(kinds.contains(RecordingFormat.Kind.EVENTS), kinds.toString());
    }
}
