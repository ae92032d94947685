package simrobot.source;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.concurrent.Callable;
import simrobot.behaviour.Answer;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;
import simrobot.process.Decision;
import simrobot.process.RobotProcess;
import simrobot.process.WaitBudget;

/**
 * One process on its own thread. The robot passes its senses every 50 ms of simulated time and receives the decision
 * with the next ones, so the delay is the same in every run. The robot brakes while a decision is late; a decision that
 * computes for 50 ms, or takes 1 s, ends the process. In the first second both limits are 1 s, because classes are
 * loaded then.
 *
 * <p>A simulation at normal pace never waits here; a faster one waits at most 50 ms a step for the decisions of all
 * robots. A run without a clock waits 1 s for each decision, so the machine's load changes no pose.
 */
final class BehaviourThread implements RobotProcess {
    private static final long PERIOD_NANOS = 50_000_000;
    private static final long COMPUTING_NANOS = 50_000_000;
    private static final long LATEST_NANOS = 1_000_000_000;
    private static final long DECISIONS_OF_FIRST_SECOND = LATEST_NANOS / PERIOD_NANOS;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final Callable<Behaviour> maker;
    private final FaultPlace place;
    private final WaitBudget budget;
    private final boolean isPatient;
    private final Thread thread;

    // ---- guarded by this -----------------------------------------------------------------------------------------
    /** Null while the behaviour has nothing to decide. */
    private Senses question;

    /** Null until the behaviour has decided. */
    private Decision answer;

    private boolean closed;

    // ---- of the robot's owner thread -----------------------------------------------------------------------------
    private Decision last = new Decision.Go(Steering.STOP);
    private boolean asked;
    private long askedNanos;
    private long computedNanos;
    private long decisions;

    /**
     * Starts the thread.
     *
     * @param maker called on that thread
     * @param place finds the line of a fault
     * @param budget of the simulation's step
     * @param isPatient true to wait for every decision until the limit ends the process
     */
    BehaviourThread(String name, Callable<Behaviour> maker, FaultPlace place, WaitBudget budget, boolean isPatient) {
        this.maker = maker;
        this.place = place;
        this.budget = budget;
        this.isPatient = isPatient;
        thread = new Thread(this::run, "behaviour " + name);
        thread.setDaemon(true);
        thread.setPriority(Thread.MIN_PRIORITY);
        thread.start();
    }

    @Override
    public long periodNanos() {
        return PERIOD_NANOS;
    }

    @Override
    public Decision decide(Senses senses) {
        if (asked) {
            Decision decided = await();
            if (decided == null) {
                return isOverdue() ? overdue() : new Decision.Go(Steering.STOP);
            }
            last = decided;
            decisions++;
            if (decided instanceof Decision.End) {
                return decided;
            }
        }
        ask(SensesSnapshot.of(senses));
        return last;
    }

    private synchronized void ask(Senses senses) {
        asked = true;
        askedNanos = System.nanoTime();
        computedNanos = computed();
        question = senses;
        answer = null;
        notifyAll();
    }

    /** Null if no decision arrives in time. */
    private synchronized Decision await() {
        long began = System.nanoTime();
        long end = isPatient
                ? askedNanos + LATEST_NANOS
                : Math.min(askedNanos + COMPUTING_NANOS, began + budget.leftNanos());
        long left = end - began;
        try {
            while (answer == null && left > 0) {
                wait(left / 1_000_000, (int) (left % 1_000_000));
                left = end - System.nanoTime();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        budget.spend(System.nanoTime() - began);
        return answer;
    }

    private boolean isOverdue() {
        long computing = decisions < DECISIONS_OF_FIRST_SECOND ? LATEST_NANOS : COMPUTING_NANOS;
        return computed() - computedNanos > computing || System.nanoTime() - askedNanos > LATEST_NANOS;
    }

    private Decision overdue() {
        boolean computes = computed() - computedNanos > COMPUTING_NANOS;
        String text = computes
                ? "computes for more than 50 ms, expected a decision: an endless loop?"
                : "no decision within 1 s: it waits for something";
        return new Decision.Failed(place.line(thread.getStackTrace()), text);
    }

    /** CPU time of the thread; 0 if the machine does not measure it. */
    private long computed() {
        return THREADS.isThreadCpuTimeSupported() ? Math.max(0, THREADS.getThreadCpuTime(thread.getId())) : 0;
    }

    // ---- the behaviour's thread ----------------------------------------------------------------------------------

    private void run() {
        try {
            Senses senses = next();
            Behaviour behaviour = senses == null ? null : maker.call();
            while (senses != null) {
                Answer made = Answer.of(behaviour, senses);
                if (made.steering() == null) {
                    answer(new Decision.Failed(0, "decide returned null, expected a Steering"));
                    return;
                }
                answer(
                        made.isDone()
                                ? new Decision.Done(made.asked())
                                : new Decision.Go(made.steering(), made.asked()));
                senses = next();
            }
        } catch (Throwable thrown) {
            answer(new Decision.Failed(place.line(thrown.getStackTrace()), FaultPlace.text(thrown)));
        }
    }

    /** Waits for the next question; null at the end. */
    private synchronized Senses next() throws InterruptedException {
        while (question == null && !closed) {
            wait();
        }
        Senses senses = closed ? null : question;
        question = null;
        return senses;
    }

    private synchronized void answer(Decision decision) {
        answer = decision;
        notifyAll();
    }

    @Override
    public void close() {
        synchronized (this) {
            closed = true;
            notifyAll();
        }
        // LoopChecks makes the loops of a source react to this
        thread.interrupt();
    }
}
