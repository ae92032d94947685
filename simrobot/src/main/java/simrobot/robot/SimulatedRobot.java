package simrobot.robot;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.Pose;
import vericommand.RobotStatus;
import vericommand.StatusEvent;
import vericommand.StatusMachine;
import vericommand.StatusRules;

/**
 * A Pioneer 2-DX on a floor. It moves only in {@link #step}; everything happens on the simulation's owner thread.
 *
 * <p>A step takes the wheels' stretch of way from the motion's profile and the belt's from the floor, sweeps the robot's
 * circle along both, and stops it at the first contact. Goals are judged by the true place, so wheels that slip go on.
 */
public final class SimulatedRobot implements Pioneer {
    /** A turn made in Collision frees the robot when this much of the way ahead is free. */
    private static final double FREE_WAY_METERS = 0.01;

    private final String name;
    private final int number;
    private final Floor floor;
    private StatusMachine machine = new StatusMachine(RobotStatus.STOPPED);
    private final List<Consumer<RobotStatus>> statusListeners = new CopyOnWriteArrayList<>();
    private final Trail trail = new Trail();
    private double x;
    private double y;
    private double heading;
    private final Direction direction = new Direction();

    /** Of the wheels: metres per second ahead. */
    private double speed;

    /** Of the wheels: radians per second clockwise. */
    private double turnSpeed;

    private final OrderedMotion ordered;
    private final DrivenMotion driven;
    private final Autonomy autonomy;
    private final Odometry odometry = new Odometry();
    private Pose odometryZero;
    private final Battery battery = new Battery();
    private ContactDirection touch = ContactDirection.NONE;
    private Noise noise = Noise.NONE;
    private long steps;

    /**
     * A robot that stands there with power and motors on.
     *
     * @param number no other robot of the floor has it; they count from 0 in the order in which they came
     */
    public SimulatedRobot(String name, int number, Floor floor, double xMeters, double yMeters, double headingRadians) {
        this.name = Objects.requireNonNull(name);
        this.number = number;
        this.floor = Objects.requireNonNull(floor);
        x = xMeters;
        y = yMeters;
        heading = headingRadians;
        odometryZero = pose();
        ordered = new OrderedMotion(this, floor);
        driven = new DrivenMotion(this, floor);
        autonomy = new Autonomy(this);
    }

    @Override
    public String name() {
        return name;
    }

    /** From 0 in the order in which the robots came to their floor. */
    public int number() {
        return number;
    }

    @Override
    public RobotStatus status() {
        return machine.status();
    }

    /** Told the new status at every change, on the owner thread, before a motion's outcome. */
    @Override
    public void addStatusListener(Consumer<RobotStatus> listener) {
        statusListeners.add(listener);
    }

    /** Told at the end of the step in which the wheels first move for a motion, on the owner thread. */
    @Override
    public void addFirstMotionListener(Runnable listener) {
        ordered.addFirstMotionListener(listener);
    }

    /** Throws the power switch; on leaves the motors off. Off ends a motion at once. */
    @Override
    public void setPower(boolean on) {
        if (on != isPowered()) {
            battery.refill();
            cut(on ? StatusEvent.POWER_ON : StatusEvent.POWER_OFF);
        }
    }

    /** Throws the motors' switch; without power nothing happens. Off ends a motion at once. */
    @Override
    public void setMotors(boolean on) {
        if (isPowered() && on != hasMotors()) {
            cut(on ? StatusEvent.MOTORS_ON : StatusEvent.MOTORS_OFF);
        }
    }

    private void cut(StatusEvent event) {
        autonomy.end();
        ordered.finish(event, MotionOutcome.Ending.ABORTED);
    }

    // ---- motion --------------------------------------------------------------------------------------------------

    @Override
    public void start(Instruction.Motion motion, Consumer<MotionOutcome> ended) {
        Objects.requireNonNull(ended);
        if (StatusRules.treatment(status(), motion) != StatusRules.Treatment.EXECUTED) {
            throw new IllegalStateException(motion.keys() + " is not possible in " + status().text());
        }
        autonomy.end();
        ordered.begin(motion, ended);
    }

    @Override
    public void brake() {
        autonomy.end();
        ordered.brake();
        driven.drive().stop();
    }

    /** Stands still at once, without slowing down; an order under way ends as one that was braked. */
    public void brakeAtOnce() {
        autonomy.end();
        stand();
        if (ordered.isUnderWay()) {
            ordered.endBraked();
        } else if (status() == RobotStatus.MOVING) {
            driven.rest();
        }
    }

    /** True while it executes an instruction or comes to a stand for one: its drive is not to be touched. */
    public boolean isUnderOrder() {
        return ordered.isUnderWay() || autonomy.isAwaited();
    }

    /** For whoever steers directly: targets hold from the next step, if it has motors and is under no order. */
    public Drive drive() {
        return driven.drive();
    }

    /** The autonomous process in it. */
    public Autonomy autonomy() {
        return autonomy;
    }

    @Override
    public boolean isAutonomous() {
        return autonomy.isActive();
    }

    @Override
    public void endAutonomy(Runnable stands) {
        autonomy.endFor(stands);
    }

    /** Moves the robot through a step of simulated time. */
    public void step(long nanos) {
        double seconds = nanos * 1e-9;
        autonomy.step(nanos);
        steps++;
        if (isPowered()) {
            battery.drain(seconds, speed, turnSpeed);
        }
        double beltX = floor.beltVelocityX(x, y) * seconds;
        double beltY = floor.beltVelocityY(x, y) * seconds;
        if (ordered.isUnderWay()) {
            ordered.step(nanos, beltX, beltY);
        } else {
            driven.step(seconds, beltX, beltY);
        }
    }

    /** The belt takes the robot along until something stops it; that is no collision of the robot's own making. */
    void carry(double dx, double dy) {
        if (dx != 0 || dy != 0) {
            advance(dx, dy, floor.sweep(this, dx, dy).contact().fraction());
        }
    }

    void touch(Floor.Encounter encounter) {
        ContactDirection here = ContactDirection.of(encounter.contact());
        touch(here);
        if (encounter.isRobot()) {
            encounter.robot().touch(here.opposite());
        }
    }

    void advance(double dx, double dy, double share) {
        x += dx * share;
        y += dy * share;
        floor.moved(this);
    }

    /** A moving robot that touches something stands still at once. */
    private void touch(ContactDirection here) {
        touch = here;
        if (ordered.isUnderWay()) {
            ordered.finish(StatusEvent.TOUCHED, MotionOutcome.Ending.COLLISION);
        } else if (status() == RobotStatus.MOVING) {
            stand();
            change(StatusEvent.TOUCHED);
        }
    }

    void stand() {
        driven.halt();
        speed = 0;
        turnSpeed = 0;
    }

    /** A gap of exactly the free way, less the gap that contact leaves, counts as free. */
    boolean isWayBlocked() {
        return !isWayFree(FREE_WAY_METERS - 1e-6);
    }

    boolean isWayFree(double way) {
        direction.to(heading);
        return !floor.sweep(this, way * direction.cos(), way * direction.sin())
                .contact()
                .touches();
    }

    void turnBy(double radians) {
        heading += radians;
    }

    void turnTo(double radians) {
        heading = radians;
    }

    void runsAt(double metersPerSecond, double radiansPerSecond) {
        speed = metersPerSecond;
        turnSpeed = 0 - radiansPerSecond;
    }

    /** Whether what was touched last is still there. */
    boolean isTouching() {
        return touch.holds(this, floor);
    }

    void change(StatusEvent event) {
        RobotStatus status = machine.apply(event);
        statusListeners.forEach(listener -> listener.accept(status));
    }

    /** Stands still at once, the motion under way aborted; for a world that changes under the wheels. */
    public void halt() {
        if (ordered.isUnderWay()) {
            ordered.finish(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.ABORTED);
        } else if (status() == RobotStatus.MOVING) {
            stand();
            change(StatusEvent.MOTION_ENDED);
        }
    }

    /**
     * Puts the robot there by hand, standing. In Collision it comes free when the way ahead of it is free there, by the
     * rule that holds for a turn.
     */
    @Override
    public Placement place(double xMeters, double yMeters, double headingRadians) {
        if (status() == RobotStatus.MOVING) {
            return Placement.MOVING;
        }
        if (!floor.isInside(xMeters, yMeters)) {
            return Placement.OUTSIDE;
        }
        if (!Double.isFinite(headingRadians) || !floor.isFree(this, xMeters, yMeters)) {
            return Placement.OCCUPIED;
        }
        x = xMeters;
        y = yMeters;
        heading = headingRadians;
        floor.moved(this);
        trail.lift();
        if (status() == RobotStatus.COLLISION && !isWayBlocked()) {
            machine.apply(StatusEvent.MOTION_STARTED);
            change(StatusEvent.MOTION_ENDED);
        }
        return Placement.DONE;
    }

    /** All that can be seen of it, to the last bit. */
    public RobotState state() {
        return RobotState.of(this);
    }

    /** Makes it look as it did, for a replay: nothing is judged, nobody is told, and it does not go on by itself. */
    public SimulatedRobot restore(RobotState state) {
        x = state.xMeters();
        y = state.yMeters();
        heading = state.headingRadians();
        runsAt(state.speedMetersPerSecond(), state.turnRadiansPerSecond());
        machine = new StatusMachine(state.status());
        autonomy.show(state.behaviour());
        odometry.restore(state.odometryXMeters(), state.odometryYMeters(), state.odometryHeadingRadians());
        floor.moved(this);
        return this;
    }

    public double xMeters() {
        return x;
    }

    public double yMeters() {
        return y;
    }

    /** Anticlockwise from +X, not wrapped. */
    public double headingRadians() {
        return heading;
    }

    /** Metres per second ahead, as the wheels have it. */
    public double speedMetersPerSecond() {
        return speed;
    }

    /** Anticlockwise, as the wheels have it. */
    public double turnRadiansPerSecond() {
        return 0 - turnSpeed;
    }

    /** The true pose, its heading in [0, 360); rounding dust below a nanometre and a nanodegree is wiped off. */
    @Override
    public Pose pose() {
        return PoseRounding.pose(x, y, heading);
    }

    /** Where its wheels say that it is. */
    public Odometry odometry() {
        return odometry;
    }

    /** From here on the wheels count from 0. */
    public void resetOdometry() {
        odometry.reset();
        odometryZero = pose();
    }

    /** What presses on its body. */
    public Bumpers bumpers() {
        return Bumpers.pressed(this, floor, touch);
    }

    public Battery battery() {
        return battery;
    }

    /** What its controller knows of itself. */
    public Condition condition() {
        return new Condition(
                battery.volts(),
                battery.isLow(),
                status() == RobotStatus.COLLISION,
                bumpers(),
                PoseRounding.pose(odometry.xMeters(), odometry.yMeters(), odometry.headingRadians()),
                odometryZero);
    }

    Noise noise() {
        return noise;
    }

    /** From now on wheels and sonars err so. */
    public void setNoise(Noise newNoise) {
        noise = newNoise;
    }

    /** The way that it has come, for drawing. */
    public Trail trail() {
        return trail;
    }

    /** What the sixteen sonars hear now, metres, sonar 0 first. */
    public double[] sonarRangesMeters() {
        double[] ranges = new double[SonarRing.COUNT];
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = sonarRangeMeters(i);
        }
        return ranges;
    }

    /** What one sonar measures now, noise included. */
    double sonarRangeMeters(int sonar) {
        return noise.sonar(Sonars.rangeMeters(this, direction.to(heading), floor, sonar), sonar, steps);
    }

    /** The same in whole millimetres, 100 to 5000. */
    @Override
    public int[] sonarRangesMillimeters() {
        return Arrays.stream(sonarRangesMeters())
                .mapToInt(meters -> (int) Math.round(meters * 1000))
                .toArray();
    }
}
