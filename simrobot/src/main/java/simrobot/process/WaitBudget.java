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

    /** A step begins. */
    public void renew() {
        leftNanos = STEP_NANOS;
    }

    /** Has a task done at the end of this step, so that what all robots ask for goes out together. */
    public void atEnd(Runnable task) {
        atEnd.add(task);
    }

    /** A step ends. */
    public void end() {
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
