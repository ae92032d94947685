package simrobot.replay;

import java.util.ArrayList;
import java.util.List;
import simgsm.console.Event;
import simgsm.octets.OctetWriter;
import simrobot.replay.RecordingFormat.Kind;
import simrobot.robot.RobotState;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.MapWriter;
import simrobot.world.World;

/**
 * Converts a simulation's steps and events to records; the core of {@link SessionRecorder}, without file and thread.
 */
final class SessionEncoder {
    /** Receives the content of each record. */
    interface Sink {
        void accept(Kind kind, long beginNanos, long endNanos, byte[] content);
    }

    /** Length of a record's content after which it is passed on. */
    private static final int RECORD_OCTETS = 64 << 10;

    /** Number of changed states after which a KEY record follows. */
    private static final int CHANGES_BETWEEN_KEYS = 20_000;

    /** Number of entries after which a KEY record follows. */
    private static final int ENTRIES_BETWEEN_KEYS = 300;

    private final Simulation simulation;
    private final Sink sink;
    private final OctetWriter entries = new OctetWriter();
    private final List<RecordedEvent> events = new ArrayList<>();
    private World world;
    private List<SimulatedRobot> robots = List.of();

    /** The last written states. */
    private RobotState[] written = {};

    private Kind openKind = Kind.KEY;
    private long openedNanos;

    /** Time of the last entry. */
    private long writtenNanos;

    /** Time of the last step. */
    private long timeNanos;

    private int changesSinceKey;
    private int entriesSinceKey;

    SessionEncoder(Simulation simulation, Sink sink) {
        this.simulation = simulation;
        this.sink = sink;
        timeNanos = simulation.timeNanos();
        beginScene();
    }

    /** Records the states after a step, and the time at its end. */
    void step(long nanos) {
        if (isSameScene() && nanos == timeNanos + Simulation.STEP_NANOS) {
            timeNanos = nanos;
            writeChanges();
            if (entries.length() >= RECORD_OCTETS) {
                closeRecord();
            }
        } else {
            endScene();
            timeNanos = nanos;
            beginScene();
        }
    }

    void event(Event event) {
        events.add(RecordedEvent.of(timeNanos, event));
    }

    /** Passes on all changes and events so far. Time without changes is written with the next change. */
    void flush() {
        if (isSameScene()) {
            writeChanges();
        }
        closeRecord();
    }

    /** Passes on the rest, with trailing time without changes. */
    void end() {
        if (isSameScene()) {
            writeChanges();
        }
        endScene();
    }

    private boolean isSameScene() {
        return simulation.world() == world && simulation.robots() == robots;
    }

    private void beginScene() {
        if (simulation.world() != world) {
            world = simulation.world();
            OctetWriter content = new OctetWriter().text(world.name()).text(MapWriter.text(world));
            sink.accept(Kind.WORLD, timeNanos, timeNanos, content.toArray());
        }
        robots = simulation.robots();
        OctetWriter names = new OctetWriter().compact(robots.size());
        robots.forEach(robot -> names.text(robot.name()));
        sink.accept(Kind.ROBOTS, timeNanos, timeNanos, names.toArray());
        written = robots.stream().map(SimulatedRobot::state).toArray(RobotState[]::new);
        writtenNanos = timeNanos;
        openKey();
        closeRecord();
    }

    private void endScene() {
        if (timeNanos > writtenNanos) {
            beginEntry();
            entries.compact(0);
        }
        closeRecord();
    }

    // ---- entries -------------------------------------------------------------------------------------------------

    private void writeChanges() {
        int next = 0;
        boolean changed = false;
        for (int i = 0; i < written.length; i++) {
            RobotState state = robots.get(i).state();
            if (!state.equals(written[i])) {
                if (!changed) {
                    beginEntry();
                    changed = true;
                }
                written[i] = state;
                writeRobot(i, next);
                next = i + 1;
                changesSinceKey++;
            }
        }
        if (changed) {
            entries.compact(0);
        }
    }

    /** @param next the robot after the last written one */
    private void writeRobot(int robot, int next) {
        entries.compact(robot - next + 1L);
        RecordingFormat.writeState(written[robot], entries);
    }

    private void beginEntry() {
        if (entries.length() == 0) {
            if (changesSinceKey >= CHANGES_BETWEEN_KEYS || entriesSinceKey >= ENTRIES_BETWEEN_KEYS) {
                openKey();
            } else {
                openKind = Kind.CHANGES;
                openedNanos = writtenNanos;
            }
        }
        entries.compact((timeNanos - writtenNanos) / Simulation.STEP_NANOS);
        writtenNanos = timeNanos;
        entriesSinceKey++;
    }

    // ---- records -------------------------------------------------------------------------------------------------

    private void openKey() {
        openKind = Kind.KEY;
        openedNanos = writtenNanos;
        entries.compact(0);
        for (int i = 0; i < written.length; i++) {
            writeRobot(i, i);
        }
        entries.compact(0);
        changesSinceKey = 0;
        entriesSinceKey = 0;
    }

    private void closeRecord() {
        if (entries.length() > 0) {
            sink.accept(openKind, openedNanos, writtenNanos, entries.toArray());
            entries.clear();
        }
        if (!events.isEmpty()) {
            OctetWriter content = new OctetWriter().compact(events.size());
            events.forEach(event -> event.write(content));
            sink.accept(Kind.EVENTS, timeNanos, timeNanos, content.toArray());
            events.clear();
        }
    }
}
