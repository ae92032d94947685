package simrobot.pioneer;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.function.Consumer;
import simrobot.behaviour.Steering;
import simrobot.p2os.InformationPacket;
import simrobot.p2os.P2osCommand;
import simrobot.p2os.P2osCommandNumber;
import simrobot.p2os.P2osPacketReader;
import simrobot.process.Surroundings;
import simrobot.robot.Bumpers;
import simrobot.robot.Pioneer;
import simrobot.robot.Placement;
import simrobot.simulation.RobotSnapshot;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.Pose;
import vericommand.RobotStatus;
import vericommand.StatusEvent;

/**
 * A Pioneer controlled over P2OS. Its status follows its information packets, ten per second: no connection is
 * Disconnected, motors off is No motors, a stall is Collision. Owned by the simulation's thread.
 */
public final class RealPioneer extends Pioneer {
    private static final Logger LOG = System.getLogger(RealPioneer.class.getName());

    /** Maximum wait for an information packet. */
    private static final long LATE_NANOS = 150_000_000;

    /** Without an information packet for this time a driven robot gets STOP. */
    private static final long BLIND_NANOS = 500_000_000;

    /** After switching the motors here, contradicting information packets are ignored for this time. */
    private static final long SWITCH_NANOS = 1_000_000_000;

    private final PioneerLine line;
    private final Surroundings surroundings;
    private P2osPacketReader reader = new P2osPacketReader(this::heard);
    private final P2osClientSession conversation;
    private final PioneerReadings readings;
    private VelocityLoop travel;
    /** The process's speeds, commanded with every information packet; null while none steers. */
    private Steering steering;
    /** True if the newest command turns the robot. */
    private boolean turns;

    private boolean motorsWanted;
    private long switchedNanos;

    /** True if the connection was lost while the robot was driven: it may resume when commands arrive. */
    private boolean lostUnderWay;

    /** True if the robot has stopped since its last instruction; coasting before that is no external motion. */
    private boolean settled;

    private long nanos;

    /**
     * Creates an unconnected robot.
     *
     * @param motors true to switch its motors on at the connection
     * @param parameters of the robot, for a type that is not built in
     * @param surroundings known to its processes
     */
    public RealPioneer(
            String name,
            PioneerLine line,
            Pose start,
            boolean motors,
            Optional<RobotParameters> parameters,
            Surroundings surroundings) {
        super(name, RobotStatus.DISCONNECTED);
        this.line = line;
        this.surroundings = surroundings;
        readings = new PioneerReadings(start, trail());
        motorsWanted = motors;
        conversation = new P2osClientSession(
                name,
                line,
                parameters,
                this::opened,
                data -> InformationPacket.read(data).ifPresent(this::take));
    }

    // ---- from the line -------------------------------------------------------------------------------------------

    /** Called when the line is connected. */
    public void connected(long nowNanos) {
        nanos = nowNanos;
        reader = new P2osPacketReader(this::heard);
        if (lostUnderWay) {
            lostUnderWay = false;
            line.send(P2osCommand.packet(P2osCommandNumber.STOP));
        }
        conversation.begin(nanos);
    }

    public void received(byte[] bytes, long nowNanos) {
        nanos = nowNanos;
        reader.read(bytes, nanos);
    }

    /** Called when the connection is lost. */
    public void disconnected() {
        conversation.end();
        lose();
    }

    /** Advances the time; called about ten times a second. */
    public void tick(long nowNanos) {
        nanos = nowNanos;
        conversation.tick(nanos);
        if (travel != null && nanos - readings.measuredNanos() > LATE_NANOS) {
            steer(travel);
        } else if (steering != null && nanos - readings.measuredNanos() > BLIND_NANOS) {
            // the process resumes with the next information packet
            steering = null;
            stop();
        }
    }

    private void heard(byte[] data) {
        conversation.heard(data, nanos);
    }

    private void lose() {
        readings.lose();
        lostUnderWay |= travel != null || autonomy().isActive();
        if (isPowered()) {
            cut(StatusEvent.POWER_OFF);
        }
    }

    private void opened() {
        readings.restart();
        settled = false;
        OpeningCommands.tell(this::tell);
        tell(P2osCommandNumber.ENABLE, motorsWanted && unknownType().isEmpty() ? 1 : 0);
        unknownType()
                .ifPresent(type -> LOG.log(
                        Level.ERROR,
                        name() + ": robot type " + type + " is not known, it is not moved; expected --pioneer-params"));
        switchedNanos = nanos;
    }

    private void tell(int command, int argument) {
        conversation.send(P2osCommand.packet(command, argument), nanos);
    }

    private void stop() {
        conversation.send(P2osCommand.packet(P2osCommandNumber.STOP), nanos);
    }

    private void take(InformationPacket information) {
        int pressedBefore = readings.newest().map(InformationPacket::bumpers).orElse(-1);
        Optional<RobotKind> kind = conversation.kind();
        long passedNanos = readings.take(information, kind, nanos);
        if (!isPowered()) {
            change(StatusEvent.POWER_ON);
        }
        if (kind.isEmpty()) {
            return;
        }
        followMotors(information);
        settled |= !information.isMoving();
        if (travel != null) {
            follow(travel, information);
        } else if (settled || autonomy().isActive()) {
            followOthers(information, information.stalled() || (information.bumpers() & ~pressedBefore) != 0);
        }
        autonomy().step(passedNanos);
        if (steering != null) {
            tell(P2osCommandNumber.VEL, (int) Math.round(steering.metersPerSecond() * 1000));
            tell(P2osCommandNumber.RVEL, (int) Math.round(Math.toDegrees(steering.radiansPerSecond())));
        }
    }

    /** Follows the motors' state, which the robot's button, e-stop or a blown fuse may change. */
    private void followMotors(InformationPacket information) {
        boolean settling = nanos - switchedNanos < SWITCH_NANOS && information.motors() != motorsWanted;
        if (!settling && information.motors() != hasMotors()) {
            cut(information.motors() ? StatusEvent.MOTORS_ON : StatusEvent.MOTORS_OFF);
        }
    }

    // ---- motion --------------------------------------------------------------------------------------------------

    private void follow(VelocityLoop under, InformationPacket information) {
        boolean hadMoved = under.hasMoved();
        VelocityLoop.Progress progress = under.judge(information, nanos);
        if (!hadMoved && under.hasMoved()) {
            tellFirstMotion();
        }
        switch (progress) {
            case TOUCHED -> {
                stop();
                finish(StatusEvent.TOUCHED, MotionOutcome.Ending.COLLISION, false);
            }
            case AT_GOAL -> {
                stop();
                rest(under, information, true);
            }
            case BRAKED -> rest(under, information, false);
            case STUCK -> {
                stop();
                finish(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.INFINITE_LOOP, false);
            }
            case UNDER_WAY -> steer(under);
        }
    }

    /** Commands the speeds for this moment; stops a robot that has sent no information packet for 0.5 s. */
    private void steer(VelocityLoop under) {
        if (under.isBraking()) {
            return;
        }
        if (nanos - readings.measuredNanos() > BLIND_NANOS) {
            under.interrupt();
            stop();
            return;
        }
        VelocityLoop.Command command = under.command(nanos, readings.measuredNanos());
        tell(P2osCommandNumber.VEL, command.millimetersPerSecond());
        if (command.degreesPerSecond() != 0 || turns) {
            tell(P2osCommandNumber.RVEL, command.degreesPerSecond());
        }
        turns = command.degreesPerSecond() != 0;
    }

    private void rest(VelocityLoop under, InformationPacket information, boolean atGoal) {
        boolean isTouched = information.stalled() || information.frontBumpers() != 0;
        boolean blocked = under.begunInCollision() && isTouched;
        MotionOutcome.Ending well = atGoal ? MotionOutcome.Ending.DONE : MotionOutcome.Ending.BRAKED;
        finish(
                blocked ? StatusEvent.TURN_ENDED_BLOCKED : StatusEvent.MOTION_ENDED,
                blocked && atGoal ? MotionOutcome.Ending.COLLISION : well,
                atGoal);
    }

    private void finish(StatusEvent event, MotionOutcome.Ending kind, boolean atGoal) {
        VelocityLoop over = travel;
        travel = null;
        settled = false;
        turns = false;
        change(event);
        over.end(kind, atGoal);
    }

    // ---- processes -----------------------------------------------------------------------------------------------

    @Override
    protected Surroundings surroundings() {
        return surroundings;
    }

    @Override
    protected void steer(Steering wanted) {
        steering = wanted;
    }

    @Override
    protected void stopSteering() {
        steering = null;
        stop();
    }

    /** Follows motion without an instruction: by a process, by hand or joystick. */
    private void followOthers(InformationPacket information, boolean touches) {
        boolean moves = information.isMoving();
        if (status() == RobotStatus.MOVING) {
            if (touches) {
                steering = null;
                stop();
                change(StatusEvent.TOUCHED);
            } else if (!moves && !autonomy().isUnfinished()) {
                change(StatusEvent.MOTION_ENDED);
            }
        } else if (moves && !information.stalled() && accepts(StatusEvent.MOTION_STARTED)) {
            change(StatusEvent.MOTION_STARTED);
        }
    }

    @Override
    protected boolean isInMotion() {
        return travel != null;
    }

    @Override
    protected void begin(Instruction.Motion motion, Consumer<MotionOutcome> ended) {
        travel = new VelocityLoop(
                motion,
                ended,
                status() == RobotStatus.COLLISION,
                readings.place(),
                conversation.kind().orElseThrow(),
                nanos);
        change(StatusEvent.MOTION_STARTED);
        steer(travel);
    }

    @Override
    public void brake() {
        autonomy().end();
        if (travel != null) {
            travel.brake(nanos);
        }
        stop();
    }

    // ---- switches ------------------------------------------------------------------------------------------------

    /** On connects, off disconnects; after on, the status changes with the robot's answer. */
    @Override
    public void setPower(boolean on) {
        if (on) {
            line.call();
        } else {
            stop();
            conversation.send(P2osCommand.packet(P2osCommandNumber.CLOSE), nanos);
            line.hangUp();
            disconnected();
        }
    }

    @Override
    public void setMotors(boolean on) {
        motorsWanted = on;
        if (isPowered() && on != hasMotors() && unknownType().isEmpty()) {
            tell(P2osCommandNumber.ENABLE, on ? 1 : 0);
            switchedNanos = nanos;
            cut(on ? StatusEvent.MOTORS_ON : StatusEvent.MOTORS_OFF);
        }
    }

    private void cut(StatusEvent event) {
        autonomy().end();
        VelocityLoop cutShort = travel;
        travel = null;
        change(event);
        if (cutShort != null) {
            cutShort.end(MotionOutcome.Ending.ABORTED, false);
        }
    }

    // ---- state ---------------------------------------------------------------------------------------------------

    @Override
    public Optional<String> unknownType() {
        return conversation.unknownType();
    }

    @Override
    protected Placement put(double xMeters, double yMeters, double headingRadians) {
        readings.setPose(xMeters, yMeters, headingRadians);
        return Placement.DONE;
    }

    @Override
    public double xMeters() {
        return readings.place().xMeters();
    }

    @Override
    public double yMeters() {
        return readings.place().yMeters();
    }

    @Override
    public double headingRadians() {
        return readings.place().headingRadians();
    }

    @Override
    public double speedMetersPerSecond() {
        return (readings.leftMetersPerSecond() + readings.rightMetersPerSecond()) / 2;
    }

    @Override
    public boolean hasLowBattery() {
        return readings.hasLowBattery();
    }

    @Override
    public Bumpers bumpers() {
        return readings.bumpers();
    }

    @Override
    public double sonarMeters(int sonar) {
        return readings.sonarMeters(sonar);
    }

    /** Returns the state for windows and the web. */
    public RobotSnapshot snapshot() {
        return readings.snapshot(this);
    }
}
