package simrobot.simulation;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

/**
 * The one thread that owns a simulation and gives it a pace in simulated seconds per second. Other threads post acts, which
 * run between two steps, and read immutable snapshots.
 *
 * <p>Elapsed real time is converted to whole steps; the remainder is carried over. After a stall of more than 250 ms the rest
 * of the debt is dropped. While nothing moves, the steps of 50 ms are made at once.
 */
public final class SimulationThread extends PacedThread {
    private static final Logger LOG = System.getLogger(SimulationThread.class.getName());

    /** Maximum real time caught up after a stall, such as a suspended laptop. */
    private static final long MAX_DEBT_NANOS = 250_000_000;

    /** Maximum duration of steps between posted acts. */
    private static final long BURST_NANOS = 4_000_000;

    private static final int MOST_STEPS_IN_BURST = 100;
    private static final long SNAPSHOT_NANOS = 15_000_000;
    private static final long REST_NANOS = 50_000_000;

    private final Simulation simulation;
    private volatile SimulationSnapshot newest;
    private volatile boolean wanted;

    // ---- owned by the thread -------------------------------------------------------------------------------------
    private long bankNanos;
    private boolean changed;
    private long publishedAt;
    /** True during a step, and for ever after a failed one. */
    private boolean stepping;

    /** A thread that has not started; until then the caller may still use the simulation. */
    public SimulationThread(Simulation simulation) {
        super("simulation");
        this.simulation = simulation;
        newest = simulation.snapshot();
    }

    /** Performs an act on the simulation itself. */
    public void withSimulation(Consumer<Simulation> act) {
        post(() -> act.accept(simulation));
    }

    /** The simulation itself, for acts on this thread. */
    public Simulation owned() {
        if (!isOwner()) {
            throw new IllegalStateException("not on the simulation's thread");
        }
        return simulation;
    }

    @Override
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
        if (isClosed()) {
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

    /** The newest snapshot. A request makes the thread take the next: without readers it takes none. */
    @Override
    public SimulationSnapshot snapshot() {
        wanted = true;
        return newest;
    }

    /** Time until the next step or snapshot is due. */
    @Override
    protected long waitNanos() {
        long picture = changed ? SNAPSHOT_NANOS : 100_000_000;
        if (isPaused()) {
            return picture;
        }
        if (!isUnlimited() && simulation.isAtRest()) {
            return REST_NANOS;
        }
        double toStep = isUnlimited() ? 0 : (Simulation.STEP_NANOS - bankNanos) / speed();
        return Math.max(0, Math.min(picture, (long) toStep));
    }

    /** Logs an act that fails, and continues; a failed step leaves the world half moved, so it ends the simulation. */
    @Override
    protected void perform(Runnable act) {
        changed = true;
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

    @Override
    protected void pass(long wallNanos) {
        makeSteps(wallNanos);
        publish(System.nanoTime());
    }

    private void makeSteps(long wallNanos) {
        if (isPaused()) {
            bankNanos = 0;
            return;
        }
        long end = System.nanoTime() + BURST_NANOS;
        if (isUnlimited()) {
            bankNanos = 0;
            do {
                step();
            } while (System.nanoTime() < end && !hasActs());
            return;
        }
        bankNanos += (long) (Math.min(wallNanos, MAX_DEBT_NANOS) * speed());
        while (bankNanos >= Simulation.STEP_NANOS && !hasActs() && System.nanoTime() < end) {
            step();
            bankNanos -= Simulation.STEP_NANOS;
        }
        bankNanos = Math.min(bankNanos, Math.max(Simulation.STEP_NANOS, (long) (MAX_DEBT_NANOS * speed())));
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
