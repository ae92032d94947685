package simrobot.simulation;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * The one thread that owns a simulation and gives it a pace in simulated seconds per second. Other threads post acts, which
 * run between two steps, and read immutable snapshots.
 *
 * <p>Elapsed real time is converted to whole steps; the remainder is carried over. After a stall of more than 250 ms the rest
 * of the debt is dropped.
 */
public final class SimulationThread implements Executor, AutoCloseable {
    /** A speed without limit: steps follow each other as fast as the machine can. */
    public static final double AS_FAST_AS_IT_CAN = Double.POSITIVE_INFINITY;

    private static final Logger LOG = System.getLogger(SimulationThread.class.getName());

    /** Real time that is made up for after a stall, such as a suspended laptop. */
    private static final long MAX_DEBT_NANOS = 250_000_000;

    /** Longest run of steps before posted acts are performed. */
    private static final long BURST_NANOS = 4_000_000;

    private static final int MOST_STEPS_IN_BURST = 100;
    private static final long SNAPSHOT_NANOS = 15_000_000;
    private static final long CLOSE_MILLIS = 5000;

    private final Simulation simulation;
    private final BlockingQueue<Runnable> acts = new LinkedBlockingQueue<>();
    private final Thread thread;
    private volatile SimulationSnapshot newest;
    private volatile boolean wanted;
    private volatile double speed = 1;
    private volatile boolean paused;
    private volatile boolean closed;
    private volatile Consumer<Throwable> onFailure =
            fault -> LOG.log(Level.ERROR, "the simulation has ended by a fault", fault);

    // ---- owned by the thread -------------------------------------------------------------------------------------
    private long bankNanos;
    private boolean changed;
    private long publishedAt;
    /** True during a step, and for ever after one that failed. */
    private boolean stepping;

    /** A thread that has not started; until then the caller may still use the simulation. */
    public SimulationThread(Simulation simulation) {
        this.simulation = simulation;
        newest = simulation.snapshot();
        thread = new Thread(this::run, "simulation");
        thread.setDaemon(true);
    }

    /**
     * Sets what happens when a step or an error ends the simulation: called once, as the thread's last act. It must not wait
     * for this thread.
     */
    public void onFailure(Consumer<Throwable> listener) {
        onFailure = listener;
    }

    public void start() {
        thread.start();
    }

    /** Performs the act on the owner thread, before the next step. Acts keep their order. */
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
        steps(1);
    }

    /**
     * Makes steps one after the other, in bursts between which other acts are performed.
     *
     * @return done after the last step; cancelled if the thread ends before
     */
    public CompletableFuture<Void> steps(int count) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        post(() -> burst(count, done));
        return done;
    }

    private void burst(int count, CompletableFuture<Void> done) {
        if (closed) {
            done.cancel(false);
            return;
        }
        int left = count;
        int last = Math.max(0, count - MOST_STEPS_IN_BURST);
        long end = System.nanoTime() + BURST_NANOS;
        try {
            do {
                step();
                left--;
            } while (left > last && System.nanoTime() < end);
        } catch (RuntimeException | Error fault) {
            done.completeExceptionally(fault);
            throw fault;
        }
        int rest = left;
        if (rest > 0) {
            post(() -> burst(rest, done));
        } else {
            done.complete(null);
        }
        publish(System.nanoTime());
    }

    /** The newest snapshot. Asking for one makes the thread take the next: without readers it takes none. */
    public SimulationSnapshot snapshot() {
        wanted = true;
        return newest;
    }

    /** Ends the thread after the acts posted so far; waits for it at most 5 s. Safe to call twice. */
    @Override
    public void close() {
        post(() -> closed = true);
        if (!isOwner() && thread.isAlive()) {
            try {
                thread.join(CLOSE_MILLIS);
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void run() {
        try {
            loop();
        } catch (RuntimeException | Error fault) {
            LOG.log(Level.DEBUG, "the simulation ends by a fault", fault);
            onFailure.accept(fault);
        }
    }

    private void loop() {
        long before = System.nanoTime();
        while (!closed) {
            try {
                performActs(waitNanos());
            } catch (InterruptedException interrupted) {
                LOG.log(Level.WARNING, "the simulation's thread was interrupted and ends");
                return;
            }
            long now = System.nanoTime();
            makeSteps(now - before);
            before = now;
            publish(now);
        }
    }

    /** Time until the next step or snapshot is due. */
    private long waitNanos() {
        long picture = changed ? SNAPSHOT_NANOS : 100_000_000;
        if (paused) {
            return picture;
        }
        double toStep = speed == AS_FAST_AS_IT_CAN ? 0 : (Simulation.STEP_NANOS - bankNanos) / speed;
        return Math.max(0, Math.min(picture, (long) toStep));
    }

    private void performActs(long waitNanos) throws InterruptedException {
        Runnable act = acts.poll(waitNanos, TimeUnit.NANOSECONDS);
        while (act != null) {
            perform(act);
            changed = true;
            act = acts.poll();
        }
    }

    /** Logs an act that fails, and goes on; a step that fails leaves the world half moved, so it ends the simulation. */
    private void perform(Runnable act) {
        try {
            act.run();
        } catch (RuntimeException fault) {
            if (stepping) {
                throw fault;
            }
            LOG.log(Level.ERROR, "an act on the simulation failed", fault);
        }
    }

    private void step() {
        stepping = true;
        simulation.step();
        stepping = false;
        changed = true;
    }

    private void makeSteps(long wallNanos) {
        if (paused) {
            bankNanos = 0;
            return;
        }
        long end = System.nanoTime() + BURST_NANOS;
        if (speed == AS_FAST_AS_IT_CAN) {
            bankNanos = 0;
            do {
                step();
            } while (System.nanoTime() < end && acts.isEmpty());
            return;
        }
        bankNanos += (long) (Math.min(wallNanos, MAX_DEBT_NANOS) * speed);
        while (bankNanos >= Simulation.STEP_NANOS && acts.isEmpty() && System.nanoTime() < end) {
            step();
            bankNanos -= Simulation.STEP_NANOS;
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
