package simrobot.simulation;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * The one thread that owns a simulation and gives it a pace: simulated seconds per second. Acts come in through
 * {@link #post} and are handled at once, between two steps; pictures go out through {@link #snapshot}.
 *
 * <p>Wall time is banked and paid out in whole steps, so no step is lost or invented; after a stall the debt is cut.
 */
public final class SimulationThread implements Executor, AutoCloseable {
    /** The pace that is no pace: steps follow each other as fast as the machine can. */
    public static final double AS_FAST_AS_IT_CAN = Double.POSITIVE_INFINITY;

    private static final Logger LOG = System.getLogger(SimulationThread.class.getName());

    /** After a stall (a suspended laptop) at most this much wall time is caught up. */
    private static final long MAX_DEBT_NANOS = 250_000_000;

    /** Acts wait at most this long behind a run of steps. */
    private static final long BURST_NANOS = 4_000_000;

    private static final long SNAPSHOT_NANOS = 15_000_000;

    private final Simulation simulation;
    private final BlockingQueue<Runnable> acts = new LinkedBlockingQueue<>();
    private final Thread thread;
    private volatile SimulationSnapshot newest;
    private volatile boolean wanted;
    private volatile double speed = 1;
    private volatile boolean paused;
    private volatile boolean closed;
    private volatile Consumer<Throwable> failed = fault -> {};

    // the thread's own
    private long bankNanos;
    private boolean changed;
    private long publishedAt;

    /** A thread that has not started; until then its maker may still touch the simulation. */
    public SimulationThread(Simulation simulation) {
        this.simulation = simulation;
        newest = simulation.snapshot();
        thread = new Thread(this::run, "simulation");
        thread.setDaemon(true);
    }

    /**
     * Who is told, on this thread as its last act, that the simulation has ended by a fault. Do not wait for the thread
     * from within.
     */
    public void onFailure(Consumer<Throwable> told) {
        failed = told;
    }

    public void start() {
        thread.start();
    }

    /** Has the act done on the owner thread, before the next step. Acts keep their order. */
    public void post(Runnable act) {
        acts.add(act);
    }

    /** The same for an act on the simulation itself. */
    public void withSimulation(Consumer<Simulation> act) {
        post(() -> act.accept(simulation));
    }

    @Override
    public void execute(Runnable act) {
        post(act);
    }

    /** The simulation itself, for acts on this thread. */
    public Simulation owned() {
        if (!isOwner()) {
            throw new IllegalStateException("not on the simulation's thread");
        }
        return simulation;
    }

    public boolean isOwner() {
        return Thread.currentThread() == thread;
    }

    /** Simulated seconds per second, above 0, or {@link #AS_FAST_AS_IT_CAN}. */
    public void setSpeed(double simulatedSecondsPerSecond) {
        if (!(simulatedSecondsPerSecond > 0)) {
            throw new IllegalArgumentException("speed " + simulatedSecondsPerSecond + ", expected above 0");
        }
        post(() -> speed = simulatedSecondsPerSecond);
    }

    public double speed() {
        return speed;
    }

    public void setPaused(boolean pause) {
        post(() -> paused = pause);
    }

    public boolean isPaused() {
        return paused;
    }

    /** Makes one step; meant for a paused simulation. */
    public void stepOnce() {
        post(simulation::step);
    }

    /** The newest picture; asking is what makes the thread take the next one. */
    public SimulationSnapshot snapshot() {
        wanted = true;
        return newest;
    }

    /** Ends the thread, once the acts posted before this are done. Safe to call twice. */
    @Override
    public void close() {
        post(() -> closed = true);
        if (!isOwner() && thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void run() {
        try {
            loop();
        } catch (RuntimeException | Error fault) {
            LOG.log(Level.ERROR, "the simulation ends by a fault: {0}", fault.toString());
            LOG.log(Level.DEBUG, "where it failed", fault);
            failed.accept(fault);
        }
    }

    private void loop() {
        long before = System.nanoTime();
        while (!closed) {
            try {
                awaitAct(pauseNanos());
            } catch (InterruptedException interrupted) {
                LOG.log(Level.WARNING, "the simulation's thread was interrupted and ends");
                return;
            }
            long now = System.nanoTime();
            payOut(now - before);
            before = now;
            publish(now);
        }
    }

    /** How long nothing is due. */
    private long pauseNanos() {
        long picture = changed ? SNAPSHOT_NANOS : 100_000_000;
        if (paused) {
            return picture;
        }
        double toStep = speed == AS_FAST_AS_IT_CAN ? 0 : (Simulation.STEP_NANOS - bankNanos) / speed;
        return Math.max(0, Math.min(picture, (long) toStep));
    }

    private void awaitAct(long nanos) throws InterruptedException {
        Runnable act = acts.poll(nanos, TimeUnit.NANOSECONDS);
        while (act != null) {
            perform(act);
            changed = true;
            act = acts.poll();
        }
    }

    /** A faulty act is logged; the robots go on. */
    private static void perform(Runnable act) {
        try {
            act.run();
        } catch (RuntimeException fault) {
            LOG.log(Level.ERROR, "an act on the simulation failed", fault);
        }
    }

    private void payOut(long wallNanos) {
        if (paused) {
            bankNanos = 0;
            return;
        }
        long end = System.nanoTime() + BURST_NANOS;
        if (speed == AS_FAST_AS_IT_CAN) {
            bankNanos = 0;
            do {
                perform(simulation::step);
            } while (System.nanoTime() < end && acts.isEmpty());
            changed = true;
            return;
        }
        bankNanos += (long) (Math.min(wallNanos, MAX_DEBT_NANOS) * speed);
        while (bankNanos >= Simulation.STEP_NANOS && acts.isEmpty() && System.nanoTime() < end) {
            perform(simulation::step);
            bankNanos -= Simulation.STEP_NANOS;
            changed = true;
        }
        bankNanos = Math.min(bankNanos, Math.max(Simulation.STEP_NANOS, (long) (MAX_DEBT_NANOS * speed)));
    }

    private void publish(long now) {
        if (wanted && changed && now - publishedAt >= SNAPSHOT_NANOS) {
            wanted = false;
            changed = false;
            publishedAt = now;
            newest = simulation.snapshot();
        }
    }
}
