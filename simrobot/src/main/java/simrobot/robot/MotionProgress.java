package simrobot.robot;

import java.util.function.Consumer;
import vericommand.Instruction;
import vericommand.MotionOutcome;

/** One motion under way: its goal, how far it has come, and how long it may take. */
final class MotionProgress {
    /** An order that takes longer than this many times its nominal duration ... */
    private static final int PATIENCE = 3;

    /** ... and this much more, in simulated time, is an infinite loop. */
    private static final double PATIENCE_SECONDS = 2;

    private static final double CENTIMETERS = 100;

    private final boolean forward;
    private final Trapezoid profile;
    private final double goal;
    private final Consumer<MotionOutcome> ended;
    private final boolean begunInCollision;
    private final double startX;
    private final double startY;
    private final double startHeading;
    private final double aheadX;
    private final double aheadY;
    private final long limitNanos;
    private double done;
    private long elapsedNanos;
    private boolean braking;

    MotionProgress(
            Instruction.Motion motion,
            Consumer<MotionOutcome> ended,
            boolean begunInCollision,
            double startX,
            double startY,
            double startHeading) {
        forward = motion instanceof Instruction.Forward;
        profile = forward ? Trapezoid.FORWARD : Trapezoid.TURN;
        goal = forward ? motion.amount() / CENTIMETERS : Math.toRadians(motion.amount());
        this.ended = ended;
        this.begunInCollision = begunInCollision;
        this.startX = startX;
        this.startY = startY;
        this.startHeading = startHeading;
        aheadX = StrictMath.cos(startHeading);
        aheadY = StrictMath.sin(startHeading);
        limitNanos = Math.round((PATIENCE * profile.seconds(goal) + PATIENCE_SECONDS) * 1e9);
    }

    boolean isForward() {
        return forward;
    }

    boolean begunInCollision() {
        return begunInCollision;
    }

    boolean isBraking() {
        return braking;
    }

    void brake() {
        braking = true;
    }

    double aheadX() {
        return aheadX;
    }

    double aheadY() {
        return aheadY;
    }

    /** The wheels' next stretch, in metres or in radians clockwise. */
    Trapezoid.Stretch next(double speed, double seconds) {
        return braking ? profile.brake(speed, seconds) : profile.towards(goal - done, speed, seconds);
    }

    /** The true place after a step forward. */
    void isAt(double x, double y) {
        done = (x - startX) * aheadX + (y - startY) * aheadY;
    }

    void hasTurnedBy(double clockwiseRadians) {
        done += clockwiseRadians;
    }

    /** The goal's heading, so that many turns add no rounding. */
    double goalHeading() {
        return startHeading - goal;
    }

    /** A tenth of a micrometre, or of a microradian: rounding, not way. */
    boolean isAtGoal() {
        return done >= goal - 1e-7;
    }

    boolean isOverdueAfter(long nanos) {
        elapsedNanos += nanos;
        return elapsedNanos >= limitNanos;
    }

    void end(MotionOutcome.Ending kind) {
        double amount = forward ? done * CENTIMETERS : Math.toDegrees(done);
        ended.accept(new MotionOutcome(kind, Math.max(0, isAtGoal() ? wholeAmount() : amount)));
    }

    private double wholeAmount() {
        return forward ? goal * CENTIMETERS : Math.toDegrees(goal);
    }
}
