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
 * Executes one instruction on a real robot as a sequence of legs of at most 30 m or 150 degrees. The robot's controller
 * executes each leg; its odometry shows when the leg is over. If the robot stops off the goal, the next leg or a
 * correction follows.
 */
final class InstructionLegs {
    /** Progress by the newest information packet. */
    enum Progress {
        UNDER_WAY,
        AT_GOAL,
        BRAKED,
        TOUCHED,
        OVERDUE
    }

    /** Maximum leg: many controllers take 15-bit arguments. */
    private static final int LONGEST_WAY_MILLIMETERS = 30_000;

    /** Maximum leg: controllers turn through the smaller angle, below 180 degrees. */
    private static final int LARGEST_TURN_DEGREES = 150;

    private static final double NEAR_MILLIMETERS = 2;
    private static final double NEAR_DEGREES = 0.6;

    /** Factor by which the tolerance grows after {@link #CORRECTIONS} corrections. */
    private static final double LENIENCE = 6;

    private static final int CORRECTIONS = 3;

    /** Time after which a leg without any motion counts as over. */
    private static final long SETTING_OUT_NANOS = 600_000_000;

    /** Time in which an information packet may predate the command. */
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

    /** Returns the framed command for the next leg and starts its timer. */
    byte[] nextLeg(long nanos) {
        legNanos = nanos;
        legHasMoved = false;
        int left = (int) Math.round(remaining());
        int most = forward ? LONGEST_WAY_MILLIMETERS : LARGEST_TURN_DEGREES;
        int legs = Math.max(1, (Math.abs(left) + most - 1) / most);
        int leg = left / legs;
        corrections += legs == 1 ? 1 : 0;
        // P2OS counts anticlockwise as positive
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

    /** Whether the wheels have moved since the instruction began. */
    boolean hasMoved() {
        return hasMoved;
    }

    /** Returns the distance done: millimetres or degrees clockwise. */
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

    /** Whether the leg is over with the robot at rest; call only if {@link #judge} has not ended the instruction. */
    boolean wantsNextLeg(InformationPacket information, long nanos) {
        boolean over = legHasMoved ? nanos - legNanos > IN_FLIGHT_NANOS : nanos - legNanos > SETTING_OUT_NANOS;
        return !information.isMoving() && !braking && over;
    }

    void end(MotionOutcome.Ending kind, boolean atGoal) {
        double amount = Math.max(0, atGoal ? goal : Math.min(goal, done()));
        ended.accept(new MotionOutcome(kind, forward ? amount / 10 : amount));
    }
}
