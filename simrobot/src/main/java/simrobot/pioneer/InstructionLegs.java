package simrobot.pioneer;

import java.util.function.Consumer;
import simrobot.p2os.InformationPacket;
import simrobot.p2os.P2osCommandCodec;
import simrobot.p2os.P2osCommandNumber;
import simrobot.robot.InfiniteLoopRule;
import simrobot.robot.Trapezoid;
import vericommand.Instruction;
import vericommand.MotionOutcome;

/**
 * One instruction on a real robot, in legs that its controller can take: it moves and counts by itself, so what it says
 * of its place tells when a leg is over. Stands it short of the goal, the next leg, or a correction, follows.
 */
final class InstructionLegs {
    /** What has become of it by the newest information. */
    enum Progress {
        UNDER_WAY,
        AT_GOAL,
        BRAKED,
        TOUCHED,
        OVERDUE
    }

    /** An argument has 15 bits on many controllers. */
    private static final int LONGEST_WAY_MILLIMETERS = 30_000;

    /** Controllers turn the short way round. */
    private static final int LARGEST_TURN_DEGREES = 150;

    private static final double NEAR_MILLIMETERS = 2;
    private static final double NEAR_DEGREES = 0.6;

    /** Where corrections do not help, so many times as far is near enough. */
    private static final double LENIENCE = 6;

    private static final int CORRECTIONS = 3;

    /** What a leg may take before it shows. */
    private static final long SETTING_OUT_NANOS = 600_000_000;

    /** An information packet may have left before the command came. */
    private static final long IN_FLIGHT_NANOS = 250_000_000;

    private final boolean forward;
    private final int goal;
    private final Consumer<MotionOutcome> ended;
    private final boolean begunInCollision;
    private final DeadReckoning place;
    private final double startX;
    private final double startY;
    private final double startHeading;
    private final long startNanos;
    private final long limitNanos;
    private long legNanos;
    private int corrections;
    private boolean hasMoved;
    private boolean legHasMoved;
    private boolean braking;

    InstructionLegs(
            Instruction.Motion motion,
            Consumer<MotionOutcome> ended,
            boolean begunInCollision,
            DeadReckoning place,
            long nanos) {
        forward = motion instanceof Instruction.Forward;
        goal = forward ? motion.amount() * 10 : motion.amount();
        this.ended = ended;
        this.begunInCollision = begunInCollision;
        this.place = place;
        startX = place.xMeters();
        startY = place.yMeters();
        startHeading = place.headingRadians();
        startNanos = nanos;
        Trapezoid profile = forward ? Trapezoid.FORWARD : Trapezoid.TURN;
        limitNanos = InfiniteLoopRule.limitNanos(profile, forward ? goal / 1000.0 : Math.toRadians(goal));
    }

    /** The command for the next leg, framed; to be sent at once. */
    byte[] nextLeg(long nanos) {
        legNanos = nanos;
        legHasMoved = false;
        int left = (int) Math.round(remaining());
        int most = forward ? LONGEST_WAY_MILLIMETERS : LARGEST_TURN_DEGREES;
        int legs = Math.max(1, (Math.abs(left) + most - 1) / most);
        int leg = left / legs;
        corrections += legs == 1 ? 1 : 0;
        // anticlockwise is positive there
        return forward
                ? P2osCommandCodec.packet(P2osCommandNumber.MOVE, leg)
                : P2osCommandCodec.packet(P2osCommandNumber.DHEAD, -leg);
    }

    void brake(long nanos) {
        if (!braking) {
            braking = true;
            legNanos = nanos;
        }
    }

    boolean begunInCollision() {
        return begunInCollision;
    }

    /** Whether the wheels have turned for it. */
    boolean hasMoved() {
        return hasMoved;
    }

    /** Millimetres or degrees, in the sense of the instruction. */
    private double done() {
        if (forward) {
            double way = (place.xMeters() - startX) * Math.cos(startHeading)
                    + (place.yMeters() - startY) * Math.sin(startHeading);
            return way * 1000;
        }
        return Math.toDegrees(startHeading - place.headingRadians());
    }

    private double remaining() {
        return goal - done();
    }

    private boolean isNear() {
        double near = forward ? NEAR_MILLIMETERS : NEAR_DEGREES;
        return Math.abs(remaining()) <= (corrections > CORRECTIONS ? LENIENCE * near : near);
    }

    Progress judge(InformationPacket information, long nanos) {
        boolean moves = information.isMoving();
        legHasMoved |= moves;
        hasMoved |= moves;
        if (information.stalled() && nanos - legNanos > IN_FLIGHT_NANOS && (moves || !begunInCollision)) {
            return Progress.TOUCHED;
        }
        long since = nanos - legNanos;
        if (!moves && braking && since > IN_FLIGHT_NANOS) {
            return Progress.BRAKED;
        }
        if (!moves && !braking && isNear() && (legHasMoved || since > SETTING_OUT_NANOS / 2)) {
            return Progress.AT_GOAL;
        }
        return nanos - startNanos >= limitNanos ? Progress.OVERDUE : Progress.UNDER_WAY;
    }

    /** Whether the robot stands short of the goal, or beyond it, and is to be told again. */
    boolean wantsNextLeg(InformationPacket information, long nanos) {
        boolean over = legHasMoved ? nanos - legNanos > IN_FLIGHT_NANOS : nanos - legNanos > SETTING_OUT_NANOS;
        return !information.isMoving() && !braking && over;
    }

    void end(MotionOutcome.Ending kind, boolean atGoal) {
        double amount = Math.max(0, atGoal ? goal : Math.min(goal, done()));
        ended.accept(new MotionOutcome(kind, forward ? amount / 10 : amount));
    }
}
