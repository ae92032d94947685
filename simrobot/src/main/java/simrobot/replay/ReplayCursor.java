package simrobot.replay;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import simgsm.octets.OctetReader;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;

/**
 * A place in a recording, and the simulation as it was there. The simulation is a real one whose robots are put where they
 * were, so sonars, trails and pictures are made as in the session. One thread at a time.
 */
public final class ReplayCursor {
    /** After a jump the trails of so much time before it are drawn. */
    private static final long TRAIL_NANOS = 60_000_000_000L;

    /** Beyond so many robots a jump goes without trails, to be quick. */
    private static final int MOST_TRAILS = 50;

    private final Recording recording;
    private Recording.Scene scene;
    private Simulation stage;
    private Track[] tracks;
    private String watched = "";
    private int part = -1;
    private OctetReader<DamagedException> entries;
    private long timeNanos;
    private long idleSteps;

    /** At the recording's beginning. */
    public ReplayCursor(Recording recording) throws IOException {
        this.recording = recording;
        rewindTo(0);
    }

    /** Simulated time of the state that it shows. */
    public long timeNanos() {
        return timeNanos;
    }

    public boolean isAtEnd() {
        return timeNanos >= recording.lastNanos();
    }

    /** The robots as they were. */
    public List<SimulatedRobot> robots() {
        return stage.robots();
    }

    public SimulationSnapshot snapshot() {
        return stage.snapshot();
    }

    /** This robot's sonars are in every snapshot. @param robot its name, empty for none */
    public void watch(String robot) {
        watched = robot;
        stage.watch(stage.robot(robot).orElse(null));
    }

    /** Goes to the last step that is not after this time; forward or back, within the recording. */
    public void seek(long nanos) throws IOException {
        long target = Math.max(recording.firstNanos(), Math.min(recording.lastNanos(), nanos));
        if (target < timeNanos || target > timeNanos + TRAIL_NANOS) {
            rewindTo(partFor(target));
        }
        advanceTo(target);
    }

    /** Goes on by one step. */
    public void step() throws IOException {
        advanceTo(Math.min(recording.lastNanos(), timeNanos + Simulation.STEP_NANOS));
    }

    /** The newest KEY from which the target is reached, or an older one of its scene for the trails. */
    private int partFor(long target) {
        List<Recording.Part> parts = recording.parts();
        int found = 0;
        for (int i = 0; i < parts.size() && parts.get(i).beginNanos() <= target; i++) {
            if (parts.get(i).kind() == RecordingFormat.Kind.KEY) {
                found = i;
            }
        }
        Recording.Scene there = parts.get(found).scene();
        int from = found;
        for (int i = found;
                i >= 0 && parts.get(i).scene() == there && there.robots().size() <= MOST_TRAILS;
                i--) {
            if (parts.get(i).kind() == RecordingFormat.Kind.KEY) {
                from = i;
                if (parts.get(i).beginNanos() <= target - TRAIL_NANOS) {
                    break;
                }
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
        idleSteps = 0;
        timeNanos = entered.beginNanos();
        if (entered.kind() == RecordingFormat.Kind.KEY) {
            boolean sameScene = entered.scene() == scene;
            scene = entered.scene();
            tracks = sameScene ? tracks : newTracks(scene.robots().size());
            for (Track track : tracks) {
                track.readWhole(entries);
            }
            if (sameScene) {
                showAll();
            } else {
                setStage();
            }
        }
    }

    private static Track[] newTracks(int count) {
        Track[] tracks = new Track[count];
        for (int i = 0; i < count; i++) {
            tracks[i] = new Track();
        }
        return tracks;
    }

    private void setStage() {
        stage = new Simulation(scene.world(), 0);
        stage.restoreRobots(
                scene.robots(), Arrays.stream(tracks).map(Track::state).toList());
        stage.restoredAt(timeNanos);
        watch(watched);
    }

    private void showAll() {
        for (int i = 0; i < tracks.length; i++) {
            stage.robots().get(i).restore(tracks[i].state());
        }
        stage.restoredAt(timeNanos);
    }

    private void advanceTo(long target) throws IOException {
        while (true) {
            if (idleSteps > 0) {
                long steps = Math.min(idleSteps, (target - timeNanos) / Simulation.STEP_NANOS);
                idleSteps -= steps;
                timeNanos += steps * Simulation.STEP_NANOS;
                stage.restoredAt(timeNanos);
                if (idleSteps > 0) {
                    return;
                }
            } else if (!entries.hasMore()) {
                boolean ends = part + 1 == recording.parts().size()
                        || recording.parts().get(part + 1).beginNanos() > target;
                if (ends) {
                    return;
                }
                enter(part + 1);
            } else if ((entries.peek() & 3) == RecordingFormat.STEP && timeNanos + Simulation.STEP_NANOS > target) {
                return;
            } else {
                readEntry();
            }
        }
    }

    private void readEntry() {
        long entry = entries.compact();
        long number = entry >>> 2;
        switch ((int) (entry & 3)) {
            case RecordingFormat.IDLE_STEPS -> idleSteps = number;
            case RecordingFormat.STEP -> {
                timeNanos += Simulation.STEP_NANOS;
                readChanges(number);
            }
            case RecordingFormat.IN_PLACE -> readChanges(number);
            default -> throw new DamagedException("an entry of an unknown kind");
        }
    }

    private void readChanges(long count) {
        long next = 0;
        for (long left = count; left > 0; left--) {
            long robot = next + entries.compact();
            if (robot < 0 || robot >= tracks.length) {
                throw new DamagedException("a change of robot " + robot + " of " + tracks.length);
            }
            tracks[(int) robot].readChange(entries);
            stage.robots().get((int) robot).restore(tracks[(int) robot].state());
            next = robot + 1;
        }
        stage.restoredAt(timeNanos);
    }
}
