package simrobot.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import simgsm.console.Event;
import simgsm.octets.OctetWriter;
import simrobot.robot.RobotState;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.World;

/** Turns a simulation's steps and events into records; the core of {@link SessionRecorder}, without file and thread. */
final class SessionEncoder {
    /** A record is handed on when it is so long ... */
    private static final int RECORD_OCTETS = 64 << 10;

    /** ... and reading may begin anew after so many changes. */
    private static final int CHANGES_BETWEEN_KEYS = 20_000;

    private static final int STEPS_BETWEEN_KEYS = 300;

    private final Simulation simulation;
    private final BiConsumer<RecordingFormat.Kind, byte[]> sink;
    private final OctetWriter entries = new OctetWriter();
    private final List<RecordedEvent> events = new ArrayList<>();
    private World world;
    private List<SimulatedRobot> cast = List.of();
    private Track[] tracks = {};
    private boolean open;
    private RecordingFormat.Kind openKind;
    private long openedAtNanos;
    private long timeNanos;
    private int idleSteps;
    private int changesSinceKey;
    private int stepsSinceKey;

    SessionEncoder(Simulation simulation, BiConsumer<RecordingFormat.Kind, byte[]> sink) {
        this.simulation = simulation;
        this.sink = sink;
        timeNanos = simulation.timeNanos();
        beginScene();
    }

    /** A step has been made; the time is the one after it. */
    void step(long nanos) {
        boolean sameScene = simulation.world() == world && simulation.robots() == cast;
        if (!sameScene || nanos != timeNanos + Simulation.STEP_NANOS) {
            closeRecord();
            timeNanos = nanos;
            beginScene();
            return;
        }
        int changed = countChanged();
        if (changed == 0) {
            idleSteps++;
        } else {
            openRecord();
            putIdle();
            entries.compact((long) changed << 2 | RecordingFormat.STEP);
            putChanges();
            changesSinceKey += changed;
            stepsSinceKey++;
        }
        timeNanos = nanos;
        if (entries.length() >= RECORD_OCTETS) {
            closeRecord();
        }
    }

    void event(Event event) {
        events.add(RecordedEvent.of(timeNanos, event));
    }

    /** Hands on all that there is to tell; of time in which nothing happens nothing is told before something does. */
    void flush() {
        if (simulation.world() == world && simulation.robots() == cast) {
            int changed = countChanged();
            if (changed > 0) {
                openRecord();
                putIdle();
                entries.compact((long) changed << 2 | RecordingFormat.IN_PLACE);
                putChanges();
            }
        }
        if (open && entries.length() > 0) {
            closeRecord();
        }
        closeEvents();
    }

    /** The last that is told: also time in which nothing happened. */
    void end() {
        if (idleSteps > 0) {
            openRecord();
        }
        flush();
        closeRecord();
    }

    // ---- scenes --------------------------------------------------------------------------------------------------

    private void beginScene() {
        if (simulation.world() != world) {
            world = simulation.world();
            OctetWriter out = new OctetWriter();
            WorldCodec.write(world, out);
            sink.accept(RecordingFormat.Kind.WORLD, out.toArray());
        }
        cast = simulation.robots();
        OctetWriter names = new OctetWriter().compact(cast.size());
        cast.forEach(robot -> names.text(robot.name()));
        sink.accept(RecordingFormat.Kind.CAST, names.toArray());
        tracks = new Track[cast.size()];
        OctetWriter nothing = new OctetWriter();
        for (int i = 0; i < tracks.length; i++) {
            tracks[i] = new Track();
            tracks[i].writeWhole(cast.get(i).state(), nothing);
        }
        openKey();
        closeRecord();
    }

    // ---- records -------------------------------------------------------------------------------------------------

    private void openRecord() {
        if (open) {
            return;
        }
        if (changesSinceKey >= CHANGES_BETWEEN_KEYS || stepsSinceKey >= STEPS_BETWEEN_KEYS) {
            openKey();
        } else {
            open(RecordingFormat.Kind.CHANGES);
        }
    }

    /** Time that passed idly before it belongs to what goes on from there. */
    private void open(RecordingFormat.Kind kind) {
        open = true;
        openKind = kind;
        openedAtNanos = timeNanos - idleSteps * Simulation.STEP_NANOS;
    }

    private void openKey() {
        open(RecordingFormat.Kind.KEY);
        for (Track track : tracks) {
            track.writeWhole(track.state(), entries);
        }
        changesSinceKey = 0;
        stepsSinceKey = 0;
    }

    private void closeRecord() {
        if (!open && idleSteps > 0) {
            openRecord();
        }
        if (open) {
            putIdle();
            byte[] told = entries.toArray();
            OctetWriter content = new OctetWriter().eightOctets(openedAtNanos).eightOctets(timeNanos);
            content.bytes(told);
            entries.clear();
            open = false;
            sink.accept(openKind, content.toArray());
        }
    }

    private void closeEvents() {
        if (!events.isEmpty()) {
            OctetWriter content = new OctetWriter().compact(events.size());
            long before = 0;
            for (RecordedEvent event : events) {
                event.write(content, before);
                before = event.timeNanos();
            }
            events.clear();
            sink.accept(RecordingFormat.Kind.EVENTS, content.toArray());
        }
    }

    // ---- entries -------------------------------------------------------------------------------------------------

    private void putIdle() {
        if (idleSteps > 0) {
            entries.compact((long) idleSteps << 2 | RecordingFormat.IDLE_STEPS);
            idleSteps = 0;
        }
    }

    private int countChanged() {
        int changed = 0;
        for (int i = 0; i < tracks.length; i++) {
            if (tracks[i].differs(cast.get(i).state())) {
                changed++;
            }
        }
        return changed;
    }

    private void putChanges() {
        int next = 0;
        for (int i = 0; i < tracks.length; i++) {
            RobotState state = cast.get(i).state();
            if (tracks[i].differs(state)) {
                entries.compact(i - next);
                next = i + 1;
                tracks[i].writeChange(state, entries);
            }
        }
    }
}
