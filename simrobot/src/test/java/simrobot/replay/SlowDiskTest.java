package simrobot.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simrobot.process.BehaviourKind;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.World;

/** What a recording costs the simulation's thread, counted: no write, and no wait while a disk takes nothing. */
@Timeout(60)
class SlowDiskTest {
    /** A disk that takes nothing until it is released; counts what each thread writes. */
    private static final class BlockedDisk extends OutputStream {
        private final Thread simulation = Thread.currentThread();
        private final CountDownLatch released = new CountDownLatch(1);
        private final AtomicInteger writesOfSimulation = new AtomicInteger();
        private final AtomicLong octets = new AtomicLong();
        private final CountDownLatch closed = new CountDownLatch(1);

        @Override
        public void close() {
            closed.countDown();
        }

        @Override
        public void write(int octet) {
            write(new byte[] {(byte) octet}, 0, 1);
        }

        @Override
        public void write(byte[] from, int offset, int length) {
            if (Thread.currentThread() == simulation) {
                writesOfSimulation.incrementAndGet();
            }
            try {
                released.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            octets.addAndGet(length);
        }
    }

    @Test
    void anHourOfSimulatedTimeWaitsForNoDisk() {
        Simulation simulation = new Simulation(World.bare(), 1);
        simulation.addRobot("r").autonomy().begin(BehaviourKind.WANDER);
        BlockedDisk disk = new BlockedDisk();
        SessionRecorder recorder = new SessionRecorder("session", disk, simulation, act -> {});
        simulation.run(360_000);
        assertEquals(3_600_000_000_000L, simulation.timeNanos());
        assertEquals(0, disk.octets.get());
        disk.released.countDown();
        recorder.close();
        assertEquals(0, disk.writesOfSimulation.get());
        assertTrue(disk.octets.get() > 1_000_000, disk.octets + " octets");
        assertEquals(Optional.empty(), recorder.failure());
    }

    @Test
    void aRecordingThatADiskWithoutRoomEndsIsClosedWhenTheDiskWorksAgain() throws InterruptedException {
        Simulation simulation = new Simulation(World.bare(), 1);
        BlockedDisk disk = new BlockedDisk();
        SessionRecorder recorder = new SessionRecorder("session", disk, simulation, act -> {});
        for (int i = 0; i < 1_000 && recorder.failure().isEmpty(); i++) {
            // each change of the robots is a record
            SimulatedRobot robot = simulation.addRobot("r");
            simulation.run(1);
            simulation.removeRobot(robot);
            simulation.run(1);
        }
        assertEquals(
                "the disk takes no more data", recorder.failure().orElseThrow().getMessage());
        recorder.close();
        assertEquals(1, disk.closed.getCount());
        disk.released.countDown();
        disk.closed.await();
    }

    @Test
    void aFullDiskIsReportedWithTheFilesName() {
        Simulation simulation = new Simulation(World.bare(), 1);
        simulation.addRobot("r");
        OutputStream full = new OutputStream() {
            @Override
            public void write(int octet) throws IOException {
                throw new IOException("No space left on device");
            }
        };
        SessionRecorder recorder = new SessionRecorder("session.rec", full, simulation, act -> {});
        simulation.run(100);
        IOException refused = assertThrows(IOException.class, recorder::finish);
        assertEquals("session.rec: No space left on device", refused.getMessage());
        assertEquals("No space left on device", recorder.failure().orElseThrow().getMessage());
    }
}
