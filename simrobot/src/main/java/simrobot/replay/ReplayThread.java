package simrobot.replay;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.concurrent.TimeUnit;
import simrobot.simulation.PacedThread;
import simrobot.simulation.SimulationSnapshot;

/**
 * Plays a recording at a pace, and jumps; the only thread that owns its cursor. It begins paused at the recording's
 * beginning, and pauses at its end.
 */
public final class ReplayThread extends PacedThread {
    private static final System.Logger LOG = System.getLogger(ReplayThread.class.getName());
    private static final long FRAME_NANOS = 10_000_000;

    /** Simulated time between two pictures at unlimited speed. */
    private static final long LEAP_NANOS = 1_000_000_000L;

    private final Recording recording;
    private final ReplayCursor cursor;
    private volatile SimulationSnapshot newest;
    private double positionNanos;

    /** A task of the thread. */
    private interface Act {
        void run() throws IOException;
    }

    /** A thread that has not started. */
    public ReplayThread(Recording recording) throws IOException {
        super("replay");
        this.recording = recording;
        cursor = new ReplayCursor(recording);
        newest = cursor.snapshot();
        positionNanos = cursor.timeNanos();
        pause();
    }

    /** The recording with its length, events and markers. */
    public Recording recording() {
        return recording;
    }

    /** The state at the current position; its time is the position. */
    @Override
    public SimulationSnapshot snapshot() {
        return newest;
    }

    /** Jumps there, forward or back, within the recording. */
    public void seek(long nanos) {
        postReading(() -> {
            cursor.seek(nanos);
            positionNanos = cursor.timeNanos();
        });
    }

    /** Plays or pauses; playing at the end restarts from the beginning. */
    @Override
    public void setPaused(boolean pause) {
        if (!pause && isPaused() && newest.timeNanos() >= recording.lastNanos()) {
            seek(recording.firstNanos());
        }
        super.setPaused(pause);
    }

    @Override
    public void stepOnce() {
        postReading(() -> {
            cursor.step();
            positionNanos = cursor.timeNanos();
        });
    }

    /**
     * Puts this robot's sonars into every snapshot.
     *
     * @param robot its name, empty for none
     */
    public void watch(String robot) {
        postReading(() -> cursor.watch(robot));
    }

    private void postReading(Act act) {
        post(() -> read(act));
    }

    /** Reads; pauses if the recording cannot be read. */
    private void read(Act act) {
        try {
            act.run();
            newest = cursor.snapshot();
        } catch (IOException | DamagedException e) {
            LOG.log(Level.WARNING, "{0}: the replay stops: {1}", recording.path(), e.getMessage());
            pause();
        }
    }

    /** Ends the thread and closes the recording. Safe to call twice. */
    @Override
    public void close() {
        super.close();
        try {
            recording.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing the recording", e);
        }
    }

    @Override
    protected long waitNanos() {
        return isPaused() ? TimeUnit.SECONDS.toNanos(3600) : isUnlimited() ? 0 : FRAME_NANOS;
    }

    @Override
    protected void perform(Runnable act) {
        act.run();
    }

    @Override
    protected void pass(long wallNanos) {
        if (!isPaused()) {
            read(() -> play(wallNanos));
        }
    }

    private void play(long wallNanos) throws IOException {
        positionNanos += isUnlimited() ? LEAP_NANOS : wallNanos * speed();
        cursor.seek((long) positionNanos);
        if (cursor.isAtEnd()) {
            positionNanos = cursor.timeNanos();
            pause();
        }
    }
}
