package simrobot.app.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.modem.ModemOptions;
import simgsm.speech.AudioOutput;
import simrobot.app.SessionRecording;
import simrobot.control.LoggedEvent;
import simrobot.control.SimRobot;
import simrobot.replay.Recording;
import simrobot.replay.ReplayThread;
import simrobot.replay.TimelineMarker;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.inspector.RefusalTexts;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.VeriCommandSettings;

/** What the record button wrote is shown by the window that replays it. */
@Timeout(60)
class ReplayModelTest {
    @TempDir
    Path folder;

    private String live = "";

    private static void until(BooleanSupplier condition) {
        while (!condition.getAsBoolean()) {
            LockSupport.parkNanos(1_000_000);
        }
    }

    /** A robot that runs into a wall, recorded from the button's first press to its second. */
    private Path recorded() throws Exception {
        Path file = folder.resolve("wall.session");
        Simulation simulation = new Simulation(World.of("wall", List.of(new Segment(1, -2, 1, 2))), 1);
        SimulatedRobot robot = simulation.addRobot("anna", new Position(0, 0), 0);
        VeriCommandSettings settings =
                new VeriCommandSettings(Locale.ENGLISH, Set.of(), VeriCommandSettings.OnHangup.STOP);
        try (SimRobot simRobot =
                new SimRobot(simulation, new InetSocketAddress("127.0.0.1", 1), settings, AudioOutput.SILENT)) {
            SessionRecording button = new SessionRecording(simRobot.simulation());
            simRobot.onAdded(added -> added.listen(button.listener(added.name())));
            simRobot.add(robot, new Msisdn("5550200"), Imei.random(new Random(1)), ModemOptions.STANDARD);
            simRobot.simulation().setPaused(true);
            simRobot.simulation().start();
            button.restart(Optional.of(file), (to, problem) -> {
                throw new AssertionError(problem);
            });
            simRobot.onSimulation(() -> {
                robot.start(new Instruction.Forward(100), ended -> {});
                simulation.run(600);
                live = simRobot.tracks().csv("anna");
                return null;
            });
            assertEquals(Optional.of(file), button.file());
            button.restart(Optional.empty(), (to, problem) -> {});
            simRobot.onSimulation(() -> null);
            assertEquals(Optional.empty(), button.file());
        }
        return file;
    }

    @Test
    void aRecordedCollisionIsSoughtAndSeenWithItsEventsSoFar() throws Exception {
        try (ReplayThread replay = new ReplayThread(Recording.open(recorded()))) {
            ReplayModel model = new ReplayModel(replay, new RefusalTexts(Locale.ENGLISH));
            replay.start();
            WindowSnapshot first = model.snapshot();
            assertTrue(first.paused());
            assertEquals(0, first.simulation().robots().get(0).xMeters());
            TimelineMarker collision = first.timeline().orElseThrow().markers().stream()
                    .filter(marker -> marker.kind() == TimelineMarker.Kind.COLLISION)
                    .findFirst()
                    .orElseThrow();
            model.seek(collision.timeNanos());
            until(() -> model.snapshot().simulation().timeNanos() == collision.timeNanos());
            WindowSnapshot there = model.snapshot();
            assertEquals(0.75, there.simulation().robots().get(0).xMeters(), 0.01);
            LoggedEvent last = there.events().get(there.events().size() - 1);
            assertEquals("Collision", last.line().fields().get("value"));
            assertSame(there, model.snapshot());
            model.seek(0);
            until(() -> model.snapshot().simulation().timeNanos() == 0);
            assertTrue(model.snapshot().events().size() < there.events().size());
        }
    }

    @Test
    void theTrackOfARecordingIsWhatTheRunningSessionWouldHaveWritten() throws Exception {
        Path csv = folder.resolve("anna.CSV");
        CompletableFuture<Optional<String>> answer = new CompletableFuture<>();
        try (ReplayThread replay = new ReplayThread(Recording.open(recorded()))) {
            ReplayModel model = new ReplayModel(replay, new RefusalTexts(Locale.ENGLISH));
            replay.start();
            model.export("anna", csv, answer::complete);
            assertEquals(Optional.empty(), answer.get());
            assertEquals(0, model.snapshot().simulation().timeNanos());
        }
        List<String> lines = Files.readAllLines(csv);
        assertEquals(live.lines().toList().get(0), lines.get(0));
        assertEquals("0.00,0.0000,0.0000,0.00,Stopped", lines.get(1));
        List<String> moving = lines.stream()
                .filter(line -> line.matches("[0-9.]+0,.*,Moving"))
                .toList();
        assertTrue(live.lines().toList().containsAll(moving), () -> live + "\n" + lines);
        assertTrue(moving.size() > 10, () -> lines.toString());
        assertTrue(lines.get(lines.size() - 1).endsWith(",0.7500,0.0000,0.00,Collision"), () -> lines.toString());
    }

    @Test
    void aTrackThatCannotBeWrittenIsRefusedByName() throws Exception {
        CompletableFuture<Optional<String>> answer = new CompletableFuture<>();
        try (ReplayThread replay = new ReplayThread(Recording.open(recorded()))) {
            ReplayModel model = new ReplayModel(replay, new RefusalTexts(Locale.ENGLISH));
            model.export("anna", folder.resolve("nowhere").resolve("a.csv"), answer::complete);
            assertTrue(
                    answer.get().orElseThrow().contains("a.csv"),
                    () -> answer.join().toString());
        }
    }

    @Test
    void whyNothingIsRecordedIsSaid() throws Exception {
        Simulation simulation = new Simulation(World.bare(), 1);
        VeriCommandSettings settings =
                new VeriCommandSettings(Locale.ENGLISH, Set.of(), VeriCommandSettings.OnHangup.STOP);
        List<String> problems = new java.util.concurrent.CopyOnWriteArrayList<>();
        try (SimRobot simRobot =
                new SimRobot(simulation, new InetSocketAddress("127.0.0.1", 1), settings, AudioOutput.SILENT)) {
            SessionRecording button = new SessionRecording(simRobot.simulation());
            simRobot.simulation().start();
            button.restart(
                    Optional.of(folder.resolve("nowhere").resolve("a.session")),
                    (file, why) -> problems.add(new RefusalTexts(Locale.ENGLISH).unwritable(file, why)));
            simRobot.onSimulation(() -> null);
            assertEquals(1, problems.size());
            assertTrue(problems.get(0).endsWith("a.session: the folder does not exist"), problems.toString());
        }
    }
}
