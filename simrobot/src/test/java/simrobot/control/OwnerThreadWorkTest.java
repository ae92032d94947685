package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.World;

/**
 * What other threads may cost the simulation's thread, at the largest sizes, counted and not timed: every act that reads a
 * robot's history must leave the locks that a step takes.
 */
class OwnerThreadWorkTest {
    private static final int STEPS_PER_SECOND = 100;
    private static final int ROBOTS = 50;

    private final Simulation simulation = new Simulation(World.bare(), 1);
    private final TrackLog log = new TrackLog(simulation);
    private final List<SimulatedRobot> robots = new ArrayList<>();

    @BeforeEach
    void addWanderingRobots() {
        List<String> names = new ArrayList<>();
        for (int i = 0; i < ROBOTS; i++) {
            names.add("robot-" + i);
        }
        robots.addAll(simulation.addRobots(names));
        robots.forEach(log::follow);
    }

    /** Counts what is appended, and how much of it while its thread holds the lock of the track log. */
    private final class LockCounter implements Appendable {
        private int appended;
        private int appendedUnderLock;

        private Appendable count() {
            appended++;
            appendedUnderLock += Thread.holdsLock(log) ? 1 : 0;
            return this;
        }

        @Override
        public Appendable append(CharSequence text) {
            return count();
        }

        @Override
        public Appendable append(CharSequence text, int start, int end) {
            return count();
        }

        @Override
        public Appendable append(char c) {
            return count();
        }
    }

    @Test
    void aTrackIsFormattedOutsideTheLockThatAStepTakes() throws IOException {
        SimulatedRobot robot = robots.get(0);
        for (int i = 0; i < 3_600; i++) {
            robot.place(i * 1e-4, robot.yMeters(), 0);
            simulation.run(STEPS_PER_SECOND / 10);
        }
        LockCounter out = new LockCounter();
        log.samples(robot.name()).writeCsv(out);
        assertTrue(out.appended >= 3_600, out.appended + " parts");
        assertEquals(0, out.appendedUnderLock);
    }
}
