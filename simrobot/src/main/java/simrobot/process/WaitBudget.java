package simrobot.process;

import java.util.ArrayList;
import java.util.List;

/**
 * Real time that the simulation's thread may wait for decisions in one step, shared by all robots. For that thread
 * only.
 */
public final class WaitBudget {
    /** 50 ms. */
    private static final long STEP_NANOS = 50_000_000;

    private final List<Runnable> atEnd = new ArrayList<>();
    private long leftNanos = STEP_NANOS;
    private boolean isInStep;

    /** A step begins. */
    public void renew() {
        leftNanos = STEP_NANOS;
        isInStep = true;
    }

    /**
     * Has a task done at the end of this step, so that the questions of all robots go out together; at once between two steps,
     * in which a real robot decides.
     */
    public void atEnd(Runnable task) {
        if (isInStep) {
            atEnd.add(task);
        } else {
            task.run();
        }
    }

    /** A step ends. */
    public void end() {
        isInStep = false;
        atEnd.forEach(Runnable::run);
        atEnd.clear();
    }

    public long leftNanos() {
        return leftNanos;
    }

    /** A robot has waited. */
    public void spend(long nanos) {
        leftNanos = Math.max(0, leftNanos - nanos);
    }
}
