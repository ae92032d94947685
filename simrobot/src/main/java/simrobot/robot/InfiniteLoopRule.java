package simrobot.robot;

/**
 * Decides reply tone 5, "the robot is in an infinite loop": an instruction has not ended after 3 times its nominal
 * duration, by its velocity trapezoid, plus 2 s.
 */
public final class InfiniteLoopRule {
    private static final int NOMINAL_DURATIONS = 3;
    private static final double EXTRA_SECONDS = 2;

    private InfiniteLoopRule() {}

    /** The duration after which an instruction over this distance is an infinite loop. */
    public static long limitNanos(Trapezoid profile, double distance) {
        return Math.round((NOMINAL_DURATIONS * profile.seconds(distance) + EXTRA_SECONDS) * 1e9);
    }
}
