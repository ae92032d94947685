package simrobot.pioneer;

import java.util.function.Consumer;
import simrobot.p2os.InformationPacket;
import simrobot.robot.Bumpers;
import simrobot.robot.Trapezoid;
import vericommand.Instruction;
import vericommand.MotionOutcome;

/**
 * Executes one instruction on a real robot by velocity commands. It approaches the goal by a trapezoid over the
 * remaining distance by the odometry of the newest information packet, lets the robot come to rest, and corrects the
 * error by short pulses. It requires no position controller in the robot, only wheels that follow a speed, however
 * late.
 *
 * <p>Distances are metres ahead, or radians clockwise.
 */
final class VelocityLoop {
    /** Progress by the newest information packet. */
    enum Progress {
        UNDER_WAY,
        AT_GOAL,
        BRAKED,
        TOUCHED,
        STUCK
    }

    private enum Phase {
        APPROACH,
        /** Commanded to stop; waits until the robot is at rest. */
        RESTING,
        PULSE
    }

    /** The speeds to command; degrees anticlockwise, as in P2OS. */
    record Command(int millimetersPerSecond, int degreesPerSecond) {}

    /** The differences between metres and radians. */
    private record Measures(double near, double tolerated, double creep, double pulse, double longestPulse) {
        /** Errors of 1 and 5 mm; speeds from 4 to 30 mm/s; pulses over at most 50 mm. */
        static final Measures METERS = new Measures(0.001, 0.005, 0.004, 0.03, 0.05);

        /** Errors of 0.1 and 0.5 degrees; speeds from 1 to 5 degrees/s; pulses over at most 5 degrees. */
        static final Measures RADIANS = new Measures(
                Math.toRadians(0.1), Math.toRadians(0.5), Math.toRadians(1), Math.toRadians(5), Math.toRadians(5));
    }

    /** Time between a measurement and the wheels' response to the resulting command: one cycle and the line's delay. */
    private static final double REACTION_SECONDS = 0.2;

    /** Time between two information packets. */
    private static final double CYCLE_SECONDS = 0.1;

    /** Growth of the minimum speed after a pulse that has not moved the robot, and the maximum of its total. */
    private static final double CREEP_GROWTH = 2;

    private static final double MOST_CREEP = 16;
    private static final double SLUGGISH_SECONDS = 0.5;
    private static final int MOST_PULSES = 8;

    /** Time without progress, while driven, after which the instruction counts as an infinite loop. */
    private static final double STUCK_SECONDS = 3;

    /** Maximum number of times that the goal is passed. */
    private static final int MOST_REVERSALS = 10;

    /** Turning speed per error of the heading while driving ahead, 1/s. */
    private static final double HEADING_GAIN = 1;

    private static final int MOST_HEADING_DEGREES_PER_SECOND = 10;

    /** Maximum age of an information packet at a command. */
    private static final double IN_FLIGHT_SECONDS = 0.25;

    /** Time after the command to stop from which a robot at rest counts as stopped. */
    private static final double RESTING_SECONDS = 0.15;

    private final Instruction.Motion motion;
    private final boolean forward;
    private final double goal;
    private final Trapezoid profile;
    private final Measures measures;
    private final double near;
    private final Consumer<MotionOutcome> ended;
    private final boolean begunInCollision;
    private final DeadReckoning place;
    private final double startX;
    private final double startY;
    private final double startHeading;
    private final long startNanos;

    private Phase phase = Phase.APPROACH;
    private double commanded;
    private long commandedNanos;
    private long restingNanos;
    private double creep;
    /** Distance that the current pulse still has to command, and the distance to the goal at its beginning. */
    private double pulseLeft;

    private double pulseFrom;
    private int pulses;
    private double nearest;
    private long nearestNanos;
    private int reversals;
    private boolean hasMoved;
    /**
     * Bumpers that do not count as contact: all in a turn out of a collision, else those pressed from the start, but
     * not ahead.
     */
    private int ignoredBumpers;

    private boolean braking;
    private long brakingNanos;

    VelocityLoop(
            Instruction.Motion motion,
            Consumer<MotionOutcome> ended,
            boolean begunInCollision,
            DeadReckoning place,
            RobotKind kind,
            long nanos) {
        this.motion = motion;
        forward = motion instanceof Instruction.Forward;
        goal = forward ? motion.amount() / 100.0 : Math.toRadians(motion.amount());
        profile = profile(forward, kind);
        measures = forward ? Measures.METERS : Measures.RADIANS;
        double unit = forward ? kind.millimetersPerUnit() / 1000 : 2 * Math.PI / kind.unitsPerTurn();
        near = Math.max(measures.near, unit * 0.75);
        creep = measures.creep;
        ignoredBumpers = forward ? -1 << Bumpers.COUNT_EACH : -1;
        this.ended = ended;
        this.begunInCollision = begunInCollision;
        this.place = place;
        startX = place.xMeters();
        startY = place.yMeters();
        startHeading = place.headingRadians();
        startNanos = nanos;
        commandedNanos = nanos - Math.round(CYCLE_SECONDS * 1e9);
        nearest = goal;
        nearestNanos = nanos;
    }

    private static Trapezoid profile(boolean forward, RobotKind kind) {
        Trapezoid usual = forward ? Trapezoid.FORWARD : Trapezoid.TURN;
        double most = forward ? kind.topMillimetersPerSecond() / 1000.0 : Math.toRadians(kind.topDegreesPerSecond());
        return new Trapezoid(Math.min(usual.top(), most), usual.acceleration());
    }

    // ---- commands ------------------------------------------------------------------------------------------------

    /**
     * Returns the speeds to command now.
     *
     * @param measuredNanos receipt of the newest information packet
     */
    Command command(long nanos, long measuredNanos) {
        double since = seconds(commandedNanos, nanos);
        double speed = switch (phase) {
            case APPROACH -> approach(remaining() - commanded * seconds(measuredNanos, nanos), since, nanos);
            case RESTING -> 0;
            case PULSE -> pulse(since, nanos);
        };
        commandedNanos = nanos;
        if (forward) {
            int millimeters = (int) Math.round(speed * 1000);
            commanded = millimeters / 1000.0;
            return new Command(millimeters, headingCorrection());
        }
        int degrees = (int) Math.round(Math.toDegrees(speed));
        commanded = Math.toRadians(degrees);
        return new Command(0, -degrees);
    }

    private double approach(double left, double since, long nanos) {
        double direction = Math.signum(left);
        double rest = left - commanded * CYCLE_SECONDS;
        if (rest * Math.signum(commanded) < 0 || Math.abs(rest) < near / 2) {
            return rest(nanos);
        }
        double rising = Math.max(0, commanded * direction) + profile.acceleration() * since;
        double speed = Math.min(Math.min(profile.top(), rising), brakingSpeed(Math.abs(left)));
        double least = seconds(nearestNanos, nanos) < SLUGGISH_SECONDS ? creep : creep * MOST_CREEP / 2;
        return direction * Math.max(speed, least);
    }

    /** The maximum speed for a stop within this distance, after the reaction time. */
    private double brakingSpeed(double distance) {
        double deceleration = profile.deceleration();
        return deceleration
                * (Math.sqrt(REACTION_SECONDS * REACTION_SECONDS + 2 * distance / deceleration) - REACTION_SECONDS);
    }

    private double rest(long nanos) {
        phase = Phase.RESTING;
        restingNanos = nanos;
        return 0;
    }

    /** Begins to correct the error of a robot at rest: a wheel's response may be late, but its sum is the command's. */
    private void correct() {
        double left = remaining();
        if (Math.abs(left) > measures.longestPulse) {
            phase = Phase.APPROACH;
            return;
        }
        if (phase == Phase.RESTING && pulses > 0 && Math.abs(left - pulseFrom) < Math.abs(pulseFrom) / 4) {
            creep = Math.min(creep * CREEP_GROWTH, measures.creep * MOST_CREEP);
        }
        phase = Phase.PULSE;
        pulses++;
        pulseFrom = left;
        pulseLeft = left;
        commanded = 0;
    }

    private double pulse(double since, long nanos) {
        pulseLeft -= commanded * since;
        boolean isOver = Math.abs(pulseLeft) < creep * CYCLE_SECONDS / 2 || pulseLeft * pulseFrom < 0;
        if (isOver && commanded != 0) {
            return rest(nanos);
        }
        double speed = Math.max(creep, Math.min(measures.pulse, Math.abs(pulseLeft) / CYCLE_SECONDS));
        return Math.copySign(speed, pulseFrom);
    }

    /** Turning speed, degrees/s anticlockwise, that keeps the heading of a drive ahead. */
    private int headingCorrection() {
        double degrees = Math.toDegrees(startHeading - place.headingRadians()) * HEADING_GAIN;
        int most = phase == Phase.APPROACH ? MOST_HEADING_DEGREES_PER_SECOND : 0;
        return (int) Math.round(Math.max(-most, Math.min(most, degrees)));
    }

    private static double seconds(long from, long to) {
        return (to - from) / 1e9;
    }

    void brake(long nanos) {
        if (!braking) {
            braking = true;
            brakingNanos = nanos;
        }
    }

    /**
     * Handles 0.5 s without an information packet, when the robot got STOP; the drive resumes from rest with the next
     * one.
     */
    void interrupt() {
        commanded = 0;
    }

    boolean isBraking() {
        return braking;
    }

    // ---- progress ------------------------------------------------------------------------------------------------

    boolean begunInCollision() {
        return begunInCollision;
    }

    /** True if the wheels have moved since the instruction began. */
    boolean hasMoved() {
        return hasMoved;
    }

    private double done() {
        return forward
                ? (place.xMeters() - startX) * Math.cos(startHeading)
                        + (place.yMeters() - startY) * Math.sin(startHeading)
                : startHeading - place.headingRadians();
    }

    private double remaining() {
        return goal - done();
    }

    Progress judge(InformationPacket information, long nanos) {
        boolean moves = information.isMoving();
        hasMoved |= moves;
        boolean answersUs = seconds(startNanos, nanos) > IN_FLIGHT_SECONDS;
        ignoredBumpers &= begunInCollision ? -1 : information.bumpers();
        boolean touches = information.stalled() || (information.bumpers() & ~ignoredBumpers) != 0;
        if (touches && answersUs && (moves || !begunInCollision)) {
            return Progress.TOUCHED;
        }
        if (braking) {
            return !moves && seconds(brakingNanos, nanos) > IN_FLIGHT_SECONDS ? Progress.BRAKED : Progress.UNDER_WAY;
        }
        double left = remaining();
        notice(left, moves, nanos);
        if (phase == Phase.RESTING && !moves && seconds(restingNanos, nanos) > RESTING_SECONDS) {
            boolean isPatient = pulses < MOST_PULSES || Math.abs(left) > measures.tolerated;
            if (Math.abs(left) <= near || !isPatient) {
                return Progress.AT_GOAL;
            }
            correct();
        }
        if (seconds(nearestNanos, nanos) > STUCK_SECONDS || reversals > MOST_REVERSALS) {
            return Math.abs(left) <= measures.tolerated ? Progress.AT_GOAL : Progress.STUCK;
        }
        return Progress.UNDER_WAY;
    }

    /** Notes the time of the latest progress; a robot that rolls out is not driven. */
    private void notice(double left, boolean moves, long nanos) {
        boolean passed = nearest * left < 0;
        reversals += passed ? 1 : 0;
        if (passed || Math.abs(left) < Math.abs(nearest) || phase == Phase.RESTING && moves) {
            nearest = left;
            nearestNanos = nanos;
        }
    }

    void end(MotionOutcome.Ending kind, boolean atGoal) {
        double done = forward ? done() * 100 : Math.toDegrees(done());
        ended.accept(new MotionOutcome(kind, atGoal ? motion.amount() : Math.max(0, Math.min(motion.amount(), done))));
    }
}
