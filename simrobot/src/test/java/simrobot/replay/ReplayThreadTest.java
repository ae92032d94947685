package simrobot.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.console.Event;
import simrobot.process.BehaviourKind;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationThread;
import simrobot.world.World;

/** The player of recordings: a minute in which a robot follows no wall, with an event at each tenth second. */
class ReplayThreadTest {
    private static final long SECOND = 1_000_000_000L;
    private static final long PATIENCE_SECONDS = 60;

    @TempDir
    Path folder;

    private ReplayThread player;
    private double lastX;

    @BeforeEach
    void record() throws IOException {
        Simulation simulation = new Simulation(World.bare(), 1);
        SimulatedRobot robot = simulation.addRobot("r");
        robot.autonomy().begin(BehaviourKind.WALL_FOLLOW);
        SessionRecorder recorder = SessionRecorder.open(folder.resolve("s.rec"), simulation, act -> {});
        for (int i = 1; i <= 6; i++) {
            simulation.run(1000);
            recorder.event(Event.of("order").with("robot", "r").with("text", i));
        }
        recorder.close();
        lastX = robot.xMeters();
        player = new ReplayThread(Recording.open(folder.resolve("s.rec")));
        player.start();
    }

    private static void await(BooleanSupplier condition) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!condition.getAsBoolean()) {
            assertTrue(System.nanoTime() < end, "it does not happen");
            LockSupport.parkNanos(100_000);
        }
    }

    private long position() {
        return player.snapshot().timeNanos();
    }

    @Test
    void itBeginsPausedAndPlaysToTheEnd() {
        assertTrue(player.isPaused());
        assertEquals(0, position());
        player.setSpeed(SimulationThread.AS_FAST_AS_IT_CAN);
        player.setPaused(false);
        await(() -> position() == 60 * SECOND && player.isPaused());
        assertEquals(lastX, player.snapshot().robots().get(0).xMeters());
        assertEquals(6, player.recording().events().size());
        assertEquals("order robot=r text=1", player.recording().events().get(0).line());
        player.close();
    }

    @Test
    void itJumpsForwardAndBackWithinTheRecording() {
        player.seek(35 * SECOND);
        await(() -> position() == 35 * SECOND);
        double there = player.snapshot().robots().get(0).xMeters();
        player.seek(5 * SECOND);
        await(() -> position() == 5 * SECOND);
        assertTrue(player.snapshot().robots().get(0).xMeters() < there);
        player.seek(1000 * SECOND);
        await(() -> position() == 60 * SECOND);
        player.close();
    }

    @Test
    void aStepIsOneStepOfTheSimulation() {
        player.seek(10 * SECOND - Simulation.STEP_NANOS);
        await(() -> position() == 10 * SECOND - Simulation.STEP_NANOS);
        player.stepOnce();
        await(() -> position() == 10 * SECOND);
        assertTrue(player.isPaused());
        player.close();
    }

    @Test
    void playedAtTheEndItBeginsAnew() {
        player.seek(60 * SECOND);
        await(() -> position() == 60 * SECOND);
        player.setPaused(false);
        await(() -> position() < 60 * SECOND && !player.isPaused());
        player.close();
        player.close();
    }
}
