package simrobot.process;

/**
 * Real time that the simulation's thread may wait for decisions in one step, shared by all robots. For that thread
 * only.
 */
public final class WaitBudget {
    /** 50 ms. */
    private static final long STEP_NANOS = 50_000_000;

    private long leftNanos = STEP_NANOS;

    /** A step begins. */
    public void renew() {
        leftNanos = STEP_NANOS;
    }

    public long leftNanos() {
        return leftNanos;
    }

    /** A robot has waited. */
    public void spend(long nanos) {
        leftNanos = Math.max(0, leftNanos - nanos);
    }
}
