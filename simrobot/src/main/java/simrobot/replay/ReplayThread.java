package simrobot.replay;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simrobot.simulation.SimulationSnapshot;
import simrobot.simulation.SimulationThread;

/**
 * Plays a recording at a pace: the one thread that owns its cursor. It is asked and driven like a {@link SimulationThread},
 * and jumps besides. It begins paused at the recording's beginning, and pauses at its end.
 */
public final class ReplayThread implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(ReplayThread.class.getName());
    private static final long FRAME_NANOS = 10_000_000;
    /** As fast as it can: so much simulated time between two pictures. */
    private static final long CLOSE_MILLIS = 5000;

    private static final long LEAP_NANOS = 1_000_000_000L;

    private final Recording recording;
    private final List<RecordedEvent> events;
    private final ReplayCursor cursor;
    private final BlockingQueue<Act> acts = new LinkedBlockingQueue<>();
    private final Thread thread = new Thread(this::run, "replay");
    private volatile SimulationSnapshot newest;
    private volatile boolean paused = true;
    private volatile double speed = 1;
    private volatile boolean closed;
    private volatile Consumer<RecordedEvent> listener = event -> {};
    private volatile Consumer<Throwable> onFailure =
            fault -> LOG.log(Level.ERROR, "the replay has ended by a fault", fault);
    private double positionNanos;
    private int nextEvent;

    /** What is done on the thread. */
    private interface Act {
        void run() throws IOException;
    }

    /** A thread that has not started. */
    public ReplayThread(Recording recording) throws IOException {
        this.recording = recording;
        events = recording.events();
        cursor = new ReplayCursor(recording);
        newest = cursor.snapshot();
        positionNanos = cursor.timeNanos();
        thread.setDaemon(true);
    }

    public void start() {
        thread.start();
    }

    /** Its length, its events and its markers. */
    public Recording recording() {
        return recording;
    }

    /** The state at the present position; its time is the position. */
    public SimulationSnapshot snapshot() {
        return newest;
    }

    /** Takes each event as it is played, on this thread; events that are jumped over are left out. */
    public void onEvent(Consumer<RecordedEvent> told) {
        listener = told;
    }

    /** Sets what happens when an error ends the replay: called once, as the thread's last act. */
    public void onFailure(Consumer<Throwable> faultListener) {
        onFailure = faultListener;
    }

    /** Jumps there, forward or back; within the recording. */
    public void seek(long nanos) {
        post(() -> {
            cursor.seek(nanos);
            positionNanos = cursor.timeNanos();
            nextEvent = 0;
            while (nextEvent < events.size() && events.get(nextEvent).timeNanos() <= cursor.timeNanos()) {
                nextEvent++;
            }
        });
    }

    /** Plays or pauses; played at the end it begins anew. */
    public void setPaused(boolean pause) {
        if (!pause && paused && newest.timeNanos() >= recording.lastNanos()) {
            seek(recording.firstNanos());
        }
        post(() -> paused = pause);
    }

    public boolean isPaused() {
        return paused;
    }

    /** Simulated seconds per second, above 0, or {@link SimulationThread#AS_FAST_AS_IT_CAN}. */
    public void setSpeed(double simulatedSecondsPerSecond) {
        if (!(simulatedSecondsPerSecond > 0)) {
            throw new IllegalArgumentException("speed " + simulatedSecondsPerSecond + ", expected above 0");
        }
        post(() -> speed = simulatedSecondsPerSecond);
    }

    public double speed() {
        return speed;
    }

    /** Goes on by one step of the simulation; meant for a paused replay. */
    public void stepOnce() {
        post(() -> {
            cursor.step();
            positionNanos = cursor.timeNanos();
            tellEvents();
        });
    }

    /** This robot's sonars are in every snapshot. @param robot its name, empty for none */
    public void watch(String robot) {
        post(() -> cursor.watch(robot));
    }

    private void post(Act act) {
        acts.add(act);
    }

    /** Ends the thread and closes the recording. Safe to call twice. */
    @Override
    public void close() {
        post(() -> closed = true);
        try {
            if (Thread.currentThread() != thread) {
                thread.join(CLOSE_MILLIS);
            }
            recording.close();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing the recording", e);
        }
    }

    private void run() {
        try {
            loop();
        } catch (RuntimeException | Error fault) {
            LOG.log(Level.DEBUG, "the replay ends by a fault", fault);
            onFailure.accept(fault);
        }
    }

    private void loop() {
        long before = System.nanoTime();
        while (!closed) {
            try {
                Act act = acts.poll(pauseNanos(), TimeUnit.NANOSECONDS);
                while (act != null) {
                    act.run();
                    act = acts.poll();
                }
                long now = System.nanoTime();
                play(now - before);
                before = now;
                if (newest.timeNanos() != cursor.timeNanos() || act == null) {
                    newest = cursor.snapshot();
                }
            } catch (IOException | DamagedException e) {
                LOG.log(Level.WARNING, "{0}: the replay stops: {1}", recording.path(), e.getMessage());
                paused = true;
            } catch (InterruptedException interrupted) {
                return;
            }
        }
    }

    private long pauseNanos() {
        if (paused) {
            return TimeUnit.SECONDS.toNanos(3600);
        }
        return speed == SimulationThread.AS_FAST_AS_IT_CAN ? 0 : FRAME_NANOS;
    }

    private void play(long wallNanos) throws IOException {
        if (paused) {
            return;
        }
        positionNanos += speed == SimulationThread.AS_FAST_AS_IT_CAN ? LEAP_NANOS : wallNanos * speed;
        cursor.seek((long) positionNanos);
        tellEvents();
        if (cursor.isAtEnd()) {
            positionNanos = cursor.timeNanos();
            paused = true;
        }
    }

    private void tellEvents() {
        while (nextEvent < events.size() && events.get(nextEvent).timeNanos() <= cursor.timeNanos()) {
            listener.accept(events.get(nextEvent++));
        }
    }
}
