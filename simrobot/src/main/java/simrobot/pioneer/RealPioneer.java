package simrobot.pioneer;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import simrobot.behaviour.Steering;
import simrobot.p2os.InformationPacket;
import simrobot.p2os.P2osCommandCodec;
import simrobot.p2os.P2osCommandNumber;
import simrobot.p2os.P2osPacketReader;
import simrobot.process.Surroundings;
import simrobot.robot.Autonomy;
import simrobot.robot.Battery;
import simrobot.robot.Bumpers;
import simrobot.robot.Condition;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.Placement;
import simrobot.robot.ProcessSenses;
import simrobot.robot.SonarRing;
import simrobot.robot.SteeredRobot;
import simrobot.robot.Trail;
import simrobot.simulation.RobotSnapshot;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.Pose;
import vericommand.RobotStatus;
import vericommand.StatusEvent;
import vericommand.StatusMachine;
import vericommand.StatusRules;

/**
 * A Pioneer controlled over P2OS. Its status follows its information packets, ten per second: no connection is
 * Disconnected, motors off is No motors, a stall is Collision. Owned by the simulation's thread.
 */
public final class RealPioneer implements SteeredRobot {
    private static final Logger LOG = System.getLogger(RealPioneer.class.getName());

    /** An information packet that has not come by then is not waited for. */
    private static final long LATE_NANOS = 150_000_000;

    /** Without an information packet for this time a driven robot gets STOP. */
    private static final long BLIND_NANOS = 500_000_000;

    /** After switching the motors here, contradicting information packets are ignored for this time. */
    private static final long SWITCH_NANOS = 1_000_000_000;

    private static final int BOTH_BUMPERS_STALL = 3;

    /** The robot's limits of acceleration, as multiples of those of the commanded speeds. */
    private static final double RESERVE = 1.5;

    private final String name;
    private final PioneerLine line;
    private final StatusMachine machine = new StatusMachine(RobotStatus.DISCONNECTED);
    private final List<Consumer<RobotStatus>> statusListeners = new CopyOnWriteArrayList<>();
    private final List<Runnable> firstMotionListeners = new CopyOnWriteArrayList<>();
    private P2osPacketReader reader = new P2osPacketReader(this::heard);
    private final P2osClientSession conversation;
    private final DeadReckoning place;
    private final Trail trail = new Trail();
    private final int[] sonars = new int[SonarRing.COUNT];
    private InformationPacket newest;
    private VelocityLoop travel;
    private final Autonomy autonomy;
    /** What a process wants, commanded with every information packet; null while none steers. */
    private Steering steering;

    /** Whether the newest command makes the robot turn. */
    private boolean turns;

    private boolean motorsWanted;
    private long switchedNanos;
    private long measuredNanos;

    /** Whether the connection was lost while the robot was driven: it may go on when it is spoken to again. */
    private boolean lostUnderWay;

    /** Whether the robot has stood still since its last instruction; coasting before that is no external motion. */
    private boolean settled;

    private long nanos;

    /**
     * A robot that is not connected yet.
     *
     * @param motors whether its motors are switched on when it connects
     * @param parameters of the robot, for a type that is not built in
     * @param surroundings what its processes may know
     */
    public RealPioneer(
            String name,
            PioneerLine line,
            Pose start,
            boolean motors,
            Optional<RobotParameters> parameters,
            Surroundings surroundings) {
        autonomy = new Autonomy(this, surroundings);
        this.name = Objects.requireNonNull(name);
        this.line = Objects.requireNonNull(line);
        place = new DeadReckoning(start.xMeters(), start.yMeters(), Math.toRadians(start.headingDegrees()));
        motorsWanted = motors;
        conversation = new P2osClientSession(name, line, parameters, this::opened, this::said);
        forgetSonars();
    }

    private void forgetSonars() {
        Arrays.fill(sonars, (int) (Pioneer2Dx.SONAR_RANGE_METERS * 1000));
    }

    // ---- from the line -------------------------------------------------------------------------------------------

    /** Called when the line is connected. */
    public void connected(long nowNanos) {
        nanos = nowNanos;
        reader = new P2osPacketReader(this::heard);
        if (lostUnderWay) {
            lostUnderWay = false;
            line.send(P2osCommandCodec.packet(P2osCommandNumber.STOP));
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
        if (travel != null && nanos - measuredNanos > LATE_NANOS) {
            steer(travel);
        } else if (steering != null && nanos - measuredNanos > BLIND_NANOS) {
            // the next information packet makes the process go on
            steering = null;
            stop();
        }
    }

    private void heard(byte[] data) {
        conversation.heard(data, nanos);
    }

    private void lose() {
        newest = null;
        lostUnderWay |= travel != null || autonomy.isActive();
        if (isPowered()) {
            cut(StatusEvent.POWER_OFF);
        }
    }

    /** Sets limits above those of the commanded speeds, so that the wheels follow them. */
    private void opened() {
        place.restart();
        settled = false;
        forgetSonars();
        int speed = (int) Math.round(Pioneer2Dx.TOP_SPEED_METERS_PER_SECOND * 1000);
        int turn = (int) Math.round(Math.toDegrees(Pioneer2Dx.TOP_TURN_RADIANS_PER_SECOND));
        int acceleration = (int) Math.round(Pioneer2Dx.ACCELERATION_METERS_PER_SECOND2 * 1000 * RESERVE);
        int turnAcceleration =
                (int) Math.round(Math.toDegrees(Pioneer2Dx.TURN_ACCELERATION_RADIANS_PER_SECOND2) * RESERVE);
        tell(P2osCommandNumber.SETV, speed);
        tell(P2osCommandNumber.SETRV, turn);
        tell(P2osCommandNumber.SETA, acceleration);
        tell(P2osCommandNumber.SETA, -acceleration);
        tell(P2osCommandNumber.SETRA, turnAcceleration);
        tell(P2osCommandNumber.SETRA, -turnAcceleration);
        tell(P2osCommandNumber.BUMPSTALL, BOTH_BUMPERS_STALL);
        tell(P2osCommandNumber.SONAR, 1);
        tell(P2osCommandNumber.ENABLE, motorsWanted && unknownType().isEmpty() ? 1 : 0);
        unknownType()
                .ifPresent(type -> LOG.log(
                        Level.ERROR,
                        name + ": robot type " + type + " is not known, it is not moved; expected --pioneer-params"));
        switchedNanos = nanos;
    }

    private void tell(int command, int argument) {
        conversation.send(P2osCommandCodec.packet(command, argument), nanos);
    }

    private void stop() {
        conversation.send(P2osCommandCodec.packet(P2osCommandNumber.STOP), nanos);
    }

    private void said(byte[] data) {
        InformationPacket.read(data).ifPresent(this::take);
    }

    private void take(InformationPacket information) {
        long passedNanos = newest == null ? 0 : nanos - measuredNanos;
        int pressedBefore = newest == null ? -1 : newest.bumpers();
        newest = information;
        measuredNanos = nanos;
        Optional<RobotKind> kind = conversation.kind();
        kind.ifPresent(units -> measure(information, units, passedNanos));
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
        } else if (settled || autonomy.isActive()) {
            followOthers(information, information.stalled() || (information.bumpers() & ~pressedBefore) != 0);
        }
        autonomy.step(passedNanos);
        if (steering != null) {
            drive(steering);
        }
    }

    private void measure(InformationPacket information, RobotKind kind, long passedNanos) {
        place.take(information, kind, passedNanos);
        trail.pass(place.xMeters(), place.yMeters(), nanos);
        for (InformationPacket.Echo echo : information.echoes()) {
            if (echo.sonar() < sonars.length) {
                sonars[echo.sonar()] = millimeters(echo.range() * kind.millimetersPerRangeUnit());
            }
        }
    }

    private static int millimeters(double measured) {
        long millimeters = Math.round(measured);
        return (int) Math.max(
                Pioneer2Dx.SONAR_LEAST_METERS * 1000, Math.min(Pioneer2Dx.SONAR_RANGE_METERS * 1000, millimeters));
    }

    /** Follows the motors' state: the robot's own button, e-stop or a blown fuse may change it too. */
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
            firstMotionListeners.forEach(Runnable::run);
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

    /** Commands the speeds for this moment; stops a robot that has sent no information packet for half a second. */
    private void steer(VelocityLoop under) {
        if (under.isBraking()) {
            return;
        }
        if (nanos - measuredNanos > BLIND_NANOS) {
            under.interrupt();
            stop();
            return;
        }
        VelocityLoop.Command command = under.command(nanos, measuredNanos);
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
    public Autonomy autonomy() {
        return autonomy;
    }

    @Override
    public boolean isUnderOrder() {
        return travel != null || autonomy.isAwaited();
    }

    @Override
    public void steer(Steering wanted) {
        steering = wanted;
    }

    private void drive(Steering wanted) {
        tell(P2osCommandNumber.VEL, (int) Math.round(wanted.metersPerSecond() * 1000));
        tell(P2osCommandNumber.RVEL, (int) Math.round(Math.toDegrees(wanted.radiansPerSecond())));
    }

    @Override
    public void stopSteering() {
        steering = null;
        stop();
    }

    @Override
    public void countAsMoving() {
        change(StatusEvent.MOTION_STARTED);
    }

    @Override
    public ProcessSenses newSenses() {
        return new RealSenses(this);
    }

    double sonarMeters(int sonar) {
        return sonars[sonar] / 1000.0;
    }

    /** Anticlockwise, in (-pi, pi]. */
    double headingRadians() {
        return Math.atan2(Math.sin(place.headingRadians()), Math.cos(place.headingRadians()));
    }

    double metersPerSecond() {
        double factor = conversation.kind().map(RobotKind::wheelSpeedFactor).orElse(0.0) / 1000;
        return newest == null ? 0 : (newest.leftWheel() + newest.rightWheel()) * factor / 2;
    }

    @Override
    public boolean hasLowBattery() {
        return newest != null && newest.batteryDecivolts() < Battery.LOW_VOLTS * 10;
    }

    Bumpers bumpers() {
        return newest == null ? new Bumpers(0, 0) : new Bumpers(newest.frontBumpers(), newest.rearBumpers());
    }

    /** Follows motion that no instruction caused: by a process, by hand or joystick. */
    private void followOthers(InformationPacket information, boolean touches) {
        boolean moves = information.isMoving();
        if (status() == RobotStatus.MOVING) {
            if (touches) {
                steering = null;
                stop();
                change(StatusEvent.TOUCHED);
            } else if (!moves && !autonomy.isUnfinished()) {
                change(StatusEvent.MOTION_ENDED);
            }
        } else if (moves && !information.stalled() && machine.accepts(StatusEvent.MOTION_STARTED)) {
            change(StatusEvent.MOTION_STARTED);
        }
    }

    @Override
    public void start(Instruction.Motion motion, Consumer<MotionOutcome> ended) {
        Objects.requireNonNull(ended);
        if (StatusRules.treatment(status(), motion) != StatusRules.Treatment.EXECUTED) {
            throw new IllegalStateException(motion.keys() + " is not possible in " + status().text());
        }
        autonomy.end();
        travel = new VelocityLoop(
                motion,
                ended,
                status() == RobotStatus.COLLISION,
                place,
                conversation.kind().orElseThrow(),
                nanos);
        change(StatusEvent.MOTION_STARTED);
        steer(travel);
    }

    @Override
    public void brake() {
        autonomy.end();
        if (travel != null) {
            travel.brake(nanos);
        }
        stop();
    }

    // ---- switches ------------------------------------------------------------------------------------------------

    /** On connects, off disconnects; after on, the status changes when the robot answers. */
    @Override
    public void setPower(boolean on) {
        if (on) {
            line.call();
        } else {
            stop();
            conversation.send(P2osCommandCodec.packet(P2osCommandNumber.CLOSE), nanos);
            conversation.end();
            line.hangUp();
            lose();
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
        autonomy.end();
        VelocityLoop cutShort = travel;
        travel = null;
        change(event);
        if (cutShort != null) {
            cutShort.end(MotionOutcome.Ending.ABORTED, false);
        }
    }

    private void change(StatusEvent event) {
        RobotStatus status = machine.apply(event);
        statusListeners.forEach(listener -> listener.accept(status));
    }

    // ---- state ---------------------------------------------------------------------------------------------------

    @Override
    public String name() {
        return name;
    }

    @Override
    public Optional<String> unknownType() {
        return conversation.isOpen() && conversation.kind().isEmpty()
                ? Optional.of(conversation.subclass())
                : Optional.empty();
    }

    @Override
    public RobotStatus status() {
        return machine.status();
    }

    @Override
    public void addStatusListener(Consumer<RobotStatus> listener) {
        statusListeners.add(listener);
    }

    @Override
    public void addFirstMotionListener(Runnable listener) {
        firstMotionListeners.add(listener);
    }

    @Override
    public Placement place(double xMeters, double yMeters, double headingRadians) {
        if (status() == RobotStatus.MOVING) {
            return Placement.MOVING;
        }
        place.setPose(xMeters, yMeters, headingRadians);
        trail.clear();
        return Placement.DONE;
    }

    @Override
    public Pose pose() {
        return place.pose();
    }

    @Override
    public int[] sonarRangesMillimeters() {
        return sonars.clone();
    }

    /** Returns the state that windows and the web show beside the simulated robots. */
    public RobotSnapshot snapshot() {
        boolean known = newest != null;
        double factor = conversation.kind().map(RobotKind::wheelSpeedFactor).orElse(0.0) / 1000;
        double left = known ? newest.leftWheel() * factor : 0;
        double right = known ? newest.rightWheel() * factor : 0;
        double volts = known ? newest.batteryDecivolts() / 10.0 : 0;
        return new RobotSnapshot(
                name,
                status(),
                isPowered(),
                hasMotors(),
                place.xMeters(),
                place.yMeters(),
                place.headingRadians(),
                (left + right) / 2,
                (right - left) / Pioneer2Dx.EFFECTIVE_TRACK_METERS,
                Arrays.stream(sonars)
                        .mapToDouble(millimeters -> millimeters / 1000.0)
                        .toArray(),
                new double[0],
                new Condition(volts, hasLowBattery(), known && newest.stalled(), bumpers(), pose(), new Pose(0, 0, 0)),
                trail.points(),
                autonomy.kind(),
                autonomy.path(),
                false);
    }
}
