package simrobot.simulation;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.thread.DaemonThread;

/**
 * A thread that owns a scene and gives it a pace in simulated seconds per second. Other threads post acts, which run one
 * after the other between two moments of the scene, and read immutable snapshots.
 */
public abstract class PacedThread implements Executor, AutoCloseable {
    /** Unlimited speed. */
    public static final double AS_FAST_AS_IT_CAN = Double.POSITIVE_INFINITY;

    private static final Logger LOG = System.getLogger(PacedThread.class.getName());
    private static final long CLOSE_MILLIS = 5000;

    private final BlockingQueue<Runnable> acts = new LinkedBlockingQueue<>();
    private final Thread thread;
    private volatile double speed = 1;
    private volatile boolean paused;
    private volatile boolean closed;
    private volatile Consumer<Throwable> onFailure;

    /** A thread that has not started. */
    protected PacedThread(String name) {
        onFailure = fault -> LOG.log(Level.ERROR, "the " + name + " has ended by a fault", fault);
        thread = DaemonThread.of(name, this::run);
    }

    /**
     * Sets the action after an error that ends the thread: called once, as the thread's last act. It must not wait for
     * this thread.
     */
    public final void onFailure(Consumer<Throwable> listener) {
        onFailure = listener;
    }

    public final void start() {
        thread.start();
    }

    /** Performs the act on the owner thread, before the next step. Acts keep their order. */
    public final void post(Runnable act) {
        acts.add(act);
    }

    @Override
    public final void execute(Runnable act) {
        post(act);
    }

    public final boolean isOwner() {
        return Thread.currentThread() == thread;
    }

    /** Simulated seconds per second, above 0, or {@link #AS_FAST_AS_IT_CAN}. */
    public final void setSpeed(double simulatedSecondsPerSecond) {
        if (!(simulatedSecondsPerSecond > 0)) {
            throw new IllegalArgumentException("speed " + simulatedSecondsPerSecond + ", expected above 0");
        }
        post(() -> speed = simulatedSecondsPerSecond);
    }

    public final double speed() {
        return speed;
    }

    protected final boolean isUnlimited() {
        return speed == AS_FAST_AS_IT_CAN;
    }

    public void setPaused(boolean pause) {
        post(() -> paused = pause);
    }

    public final boolean isPaused() {
        return paused;
    }

    /** Pauses at once; for the owner thread. */
    protected final void pause() {
        paused = true;
    }

    /** Makes one step; meant for a paused scene. */
    public abstract void stepOnce();

    /** The newest snapshot. */
    public abstract SimulationSnapshot snapshot();

    /** Ends the thread after the acts posted so far; waits for it at most 5 s. Safe to call twice. */
    @Override
    public void close() {
        post(() -> closed = true);
        if (!isOwner() && thread.isAlive()) {
            DaemonThread.join(thread, CLOSE_MILLIS);
        }
    }

    // ---- on the thread -------------------------------------------------------------------------------------------

    private void run() {
        try {
            loop();
        } catch (InterruptedException interrupted) {
            LOG.log(Level.WARNING, "the thread of the " + thread.getName() + " was interrupted and ends");
        } catch (RuntimeException | Error fault) {
            LOG.log(Level.DEBUG, "the " + thread.getName() + " ends by a fault", fault);
            onFailure.accept(fault);
        }
    }

    private void loop() throws InterruptedException {
        long before = System.nanoTime();
        while (!closed) {
            Runnable act = acts.poll(waitNanos(), TimeUnit.NANOSECONDS);
            long now = System.nanoTime();
            pass(now - before);
            before = now;
            if (act != null) {
                for (; act != null; act = acts.poll()) {
                    perform(act);
                }
                pass(0);
            }
        }
    }

    protected final boolean hasActs() {
        return !acts.isEmpty();
    }

    protected final boolean isClosed() {
        return closed;
    }

    /** The longest wait for an act. */
    protected abstract long waitNanos();

    protected abstract void perform(Runnable act);

    /** Handles elapsed real time: before acts the time since the last call, after them 0. */
    protected abstract void pass(long wallNanos);
}
