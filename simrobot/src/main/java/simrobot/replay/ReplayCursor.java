package simrobot.replay;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiConsumer;
import simgsm.octets.OctetReader;
import simrobot.replay.RecordingFormat.Kind;
import simrobot.robot.RobotState;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;

/**
 * A position in a recording, and the simulation at that time. The simulation is a real one with the robots restored to
 * their states, so sonars, trails and pictures are made as in the session. One thread at a time.
 */
public final class ReplayCursor {
    /** Length of the trails after a jump. */
    private static final long TRAIL_NANOS = 60_000_000_000L;

    /** Number of robots above which a jump omits the trails. */
    private static final int MAX_TRAILS = 50;

    private final Recording recording;
    private Recording.Scene scene;
    private Simulation simulation;
    private String watched = "";
    private int part;
    private OctetReader<DamagedException> entries;
    private long timeNanos;
    private long entryNanos;

    /** Time of the next entry; {@link Long#MAX_VALUE} at the end of the part. */
    private long nextEntryNanos;

    /** Creates a cursor at the recording's beginning. */
    public ReplayCursor(Recording recording) throws IOException {
        this.recording = recording;
        rewindTo(0);
        timeNanos = recording.firstNanos();
    }

    /** Simulated time of the current state. */
    public long timeNanos() {
        return timeNanos;
    }

    public boolean isAtEnd() {
        return timeNanos >= recording.lastNanos();
    }

    /** The robots at that time. */
    public List<SimulatedRobot> robots() {
        return simulation.robots();
    }

    public SimulationSnapshot snapshot() {
        return simulation.snapshot();
    }

    /**
     * Puts this robot's sonars into every snapshot.
     *
     * @param robot its name, empty for none
     */
    public void watch(String robot) {
        watched = robot;
        simulation.watch(simulation.robot(robot).orElse(null));
    }

    /** Moves to the last step that is not after this time; forward or back, within the recording. */
    public void seek(long nanos) throws IOException {
        long target = Math.max(recording.firstNanos(), Math.min(recording.lastNanos(), nanos));
        if (target < timeNanos || target > timeNanos + TRAIL_NANOS) {
            rewindTo(partFor(target));
        }
        advanceTo(target);
    }

    /** Advances by one step. */
    public void step() throws IOException {
        advanceTo(Math.min(recording.lastNanos(), timeNanos + Simulation.STEP_NANOS));
    }

    /** The last KEY before the target, or an earlier one of its scene for the trails. */
    private int partFor(long target) {
        List<Recording.Part> parts = recording.parts();
        int found = 0;
        for (int i = 0; i < parts.size() && parts.get(i).beginNanos() <= target; i++) {
            if (parts.get(i).kind() == Kind.KEY) {
                found = i;
            }
        }
        Recording.Scene there = parts.get(found).scene();
        int from = found;
        for (int i = found;
                there.robots().size() <= MAX_TRAILS && i >= 0 && parts.get(i).scene() == there;
                i--) {
            if (parts.get(i).kind() == Kind.KEY && parts.get(from).beginNanos() > target - TRAIL_NANOS) {
                from = i;
            }
        }
        return from;
    }

    private void rewindTo(int key) throws IOException {
        scene = null;
        enter(key);
    }

    private void enter(int next) throws IOException {
        Recording.Part entered = recording.parts().get(next);
        part = next;
        entries = recording.entries(entered);
        entryNanos = entered.beginNanos();
        readSteps();
        if (entered.scene() != scene) {
            scene = entered.scene();
            RobotState[] states = new RobotState[scene.robots().size()];
            readRobots((robot, state) -> states[robot] = state);
            if (Arrays.asList(states).contains(null)) {
                throw new DamagedException("the state of a robot is missing");
            }
            simulation = new Simulation(scene.world(), 0);
            simulation.restoreRobots(scene.robots(), List.of(states));
            simulation.restoredAt(entryNanos);
            watch(watched);
        }
    }

    /** Reads the time of the next entry, if there is one. */
    private void readSteps() {
        nextEntryNanos = entries.hasMore() ? entryNanos + entries.compact() * Simulation.STEP_NANOS : Long.MAX_VALUE;
    }

    private void readRobots(BiConsumer<Integer, RobotState> taker) {
        long robot = -1;
        for (long skipped = entries.compact(); skipped != 0; skipped = entries.compact()) {
            robot += skipped;
            if (robot < 0 || robot >= scene.robots().size()) {
                throw new DamagedException(
                        "the state of robot " + robot + " of " + scene.robots().size());
            }
            taker.accept((int) robot, RecordingFormat.readState(entries));
        }
        entryNanos = nextEntryNanos;
        readSteps();
    }

    private void advanceTo(long target) throws IOException {
        while (nextEntryNanos <= target || hasFurtherPartUntil(target)) {
            if (nextEntryNanos <= target) {
                readRobots((robot, state) -> simulation.robots().get(robot).restore(state));
                simulation.restoredAt(entryNanos);
            } else {
                enter(part + 1);
            }
        }
        timeNanos = entryNanos + (target - entryNanos) / Simulation.STEP_NANOS * Simulation.STEP_NANOS;
        simulation.restoredAt(timeNanos);
    }

    /** True if the part has been read to its end, and the next one begins by then. */
    private boolean hasFurtherPartUntil(long target) {
        List<Recording.Part> parts = recording.parts();
        return nextEntryNanos == Long.MAX_VALUE
                && part + 1 < parts.size()
                && parts.get(part + 1).beginNanos() <= target;
    }
}
