package simrobot.robot;

import java.util.function.Consumer;
import vericommand.Instruction;
import vericommand.MotionOutcome;

/** One motion of an order: its goal, the part done so far, and its time limit. */
final class MotionProgress {
    private static final double CENTIMETERS = 100;

    private final SimulatedRobot robot;
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
    private long elapsedNanos;
    private boolean braking;

    MotionProgress(
            SimulatedRobot robot, Instruction.Motion motion, Consumer<MotionOutcome> ended, boolean begunInCollision) {
        this.robot = robot;
        forward = motion instanceof Instruction.Forward;
        profile = forward ? Trapezoid.FORWARD : Trapezoid.TURN;
        goal = forward ? motion.amount() / CENTIMETERS : Math.toRadians(motion.amount());
        this.ended = ended;
        this.begunInCollision = begunInCollision;
        startX = robot.xMeters();
        startY = robot.yMeters();
        startHeading = robot.headingRadians();
        aheadX = StrictMath.cos(startHeading);
        aheadY = StrictMath.sin(startHeading);
        limitNanos = InfiniteLoopRule.limitNanos(profile, goal);
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

    /** The next step, in metres or in radians clockwise. */
    Trapezoid.Step next(double speed, double seconds) {
        return braking ? profile.brake(speed, seconds) : profile.towards(goal - done(), speed, seconds);
    }

    /** The motion of the robot's true pose, metres or radians clockwise. */
    private double done() {
        return forward
                ? (robot.xMeters() - startX) * aheadX + (robot.yMeters() - startY) * aheadY
                : startHeading - robot.headingRadians();
    }

    /** The heading at the goal, computed from the start so that many turns add no rounding error. */
    double goalHeading() {
        return startHeading - goal;
    }

    /** True if the goal is reached within 0.1 micrometres or microradians. */
    boolean isAtGoal() {
        return done() >= goal - 1e-7;
    }

    /** Adds a step's duration; true once the motion is an infinite loop. */
    boolean isInfiniteLoopAfter(long nanos) {
        elapsedNanos += nanos;
        return elapsedNanos >= limitNanos;
    }

    void end(MotionOutcome.Ending kind) {
        double amount = forward ? done() * CENTIMETERS : Math.toDegrees(done());
        ended.accept(new MotionOutcome(kind, Math.max(0, isAtGoal() ? wholeAmount() : amount)));
    }

    private double wholeAmount() {
        return forward ? goal * CENTIMETERS : Math.toDegrees(goal);
    }
}
