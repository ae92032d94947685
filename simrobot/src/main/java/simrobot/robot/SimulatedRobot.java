package simrobot.robot;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.Pose;
import vericommand.RobotStatus;
import vericommand.StatusEvent;
import vericommand.StatusMachine;
import vericommand.StatusRules;

/**
 * A simulated Pioneer 2-DX. It moves only in {@link #step}; owned by the simulation's thread.
 *
 * <p>A step takes the wheels' distance from the motion's profile and the belt's from the floor, sweeps the robot's circle along
 * their sum, and stops it at the first contact. Goals are judged by the true place, so wheels that slip go on.
 */
public final class SimulatedRobot implements SteeredRobot {
    /** A turn made in Collision frees the robot if the path ahead is free over this distance. */
    private static final double FREE_PATH_METERS = 0.01;

    private final String name;
    private final int number;
    private final Floor floor;
    private StatusMachine machine = new StatusMachine(RobotStatus.STOPPED);
    private final List<Consumer<RobotStatus>> statusListeners = new CopyOnWriteArrayList<>();
    private final Trail trail = new Trail();
    private double x;
    private double y;
    private double heading;
    private final Rotation direction = new Rotation();

    /** Of the wheels: metres per second ahead. */
    private double speed;

    /** Of the wheels: radians per second clockwise. */
    private double turnSpeed;

    private final Wheels wheels;
    private final OrderedMotion ordered;
    private final DrivenMotion driven;
    private final Autonomy autonomy;
    private final Odometry odometry = new Odometry();
    private Pose odometryZero;
    private final Battery battery = new Battery();
    private ContactDirection touch = ContactDirection.NONE;
    private Noise noise = Noise.NONE;
    private final Sonars sonars;
    private boolean laserOn;

    /**
     * A robot that stands there with power and motors on.
     *
     * @param number unique on the floor, from 0 in the order in which the robots were added
     */
    public SimulatedRobot(String name, int number, Floor floor, double xMeters, double yMeters, double headingRadians) {
        this.name = Objects.requireNonNull(name);
        this.number = number;
        this.floor = Objects.requireNonNull(floor);
        x = xMeters;
        y = yMeters;
        heading = headingRadians;
        odometryZero = pose();
        wheels = new Wheels(this, floor);
        ordered = new OrderedMotion(this, wheels);
        driven = new DrivenMotion(this, wheels);
        autonomy = new Autonomy(this, new FloorSurroundings(this, floor));
        sonars = new Sonars(this, floor);
    }

    @Override
    public String name() {
        return name;
    }

    /** From 0, in the order in which the robots were added. */
    public int number() {
        return number;
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
        ordered.addFirstMotionListener(listener);
    }

    /** Switches the power; on leaves the motors off. Off ends a motion at once. */
    @Override
    public void setPower(boolean on) {
        if (on != isPowered()) {
            battery.refill();
            cut(on ? StatusEvent.POWER_ON : StatusEvent.POWER_OFF);
        }
    }

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

    /** Stops at once, without deceleration; a motion of an order ends as one that was braked. */
    public void brakeAtOnce() {
        autonomy.end();
        stand();
        if (ordered.isUnderWay()) {
            ordered.endBraked();
        } else if (status() == RobotStatus.MOVING) {
            driven.rest();
        }
    }

    /** True while it executes an instruction or slows down for one: its drive must not be used. */
    @Override
    public boolean isUnderOrder() {
        return ordered.isUnderWay() || autonomy.isAwaited();
    }

    /** The drive, for direct control: targets take effect in the next step, with motors on and without an order. */
    public Drive drive() {
        return driven.drive();
    }

    @Override
    public Autonomy autonomy() {
        return autonomy;
    }

    @Override
    public void steer(Steering steering) {
        drive().setSpeed(steering.metersPerSecond());
        drive().setTurnSpeed(steering.radiansPerSecond());
    }

    @Override
    public void stopSteering() {
        drive().stop();
    }

    @Override
    public void countAsMoving() {
        change(StatusEvent.MOTION_STARTED);
    }

    @Override
    public ProcessSenses newSenses() {
        return new RobotSenses(this);
    }

    /** Moves the robot through a step of simulated time. */
    public void step(long nanos) {
        double seconds = nanos * 1e-9;
        autonomy.step(nanos);
        if (isPowered()) {
            battery.drain(seconds, speed, turnSpeed);
        }
        double startX = x;
        double startY = y;
        wheels.begin(seconds);
        if (ordered.isUnderWay()) {
            ordered.step(nanos);
        } else {
            driven.step(seconds);
        }
        floor.stepped(x - startX, y - startY);
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

    /** Stops a moving robot that touches something. */
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
        setSpeeds(0, 0);
    }

    /** Whether the path ahead is free over less than 1 cm, the gap that a contact leaves not counted. */
    boolean isPathBlocked() {
        return !isPathFree(FREE_PATH_METERS - 1e-6);
    }

    boolean isPathFree(double distance) {
        direction.to(heading);
        return !floor.sweep(this, distance * direction.cos(), distance * direction.sin())
                .contact()
                .touches();
    }

    void turnBy(double radians) {
        heading += radians;
    }

    void turnTo(double radians) {
        heading = radians;
    }

    void setSpeeds(double metersPerSecond, double radiansPerSecond) {
        boolean stands = metersPerSecond == 0 && radiansPerSecond == 0;
        if (stands && (speed != 0 || turnSpeed != 0)) {
            sonars.rest();
        }
        speed = metersPerSecond;
        turnSpeed = 0 - radiansPerSecond;
    }

    /** Whether the obstacle that was touched last is still there. */
    boolean isTouching() {
        return touch.persists(this, floor);
    }

    void change(StatusEvent event) {
        RobotStatus status = machine.apply(event);
        statusListeners.forEach(listener -> listener.accept(status));
    }

    /** Stops at once and aborts the motion; for a change of the world. */
    public void halt() {
        if (ordered.isUnderWay()) {
            ordered.finish(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.ABORTED);
        } else if (status() == RobotStatus.MOVING) {
            stand();
            change(StatusEvent.MOTION_ENDED);
        }
    }

    /**
     * Moves the robot there by hand. In Collision it becomes Stopped if the path ahead is free there, by the rule for turns.
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
        floor.placed(this);
        trail.lift();
        if (status() == RobotStatus.COLLISION && !isPathBlocked()) {
            machine.apply(StatusEvent.MOTION_STARTED);
            change(StatusEvent.MOTION_ENDED);
        }
        return Placement.DONE;
    }

    /** Its observable state, to the last bit. */
    public RobotState state() {
        return RobotState.of(this);
    }

    /** Sets its state, for a replay: no listener is called, and it does not move by itself. */
    public SimulatedRobot restore(RobotState state) {
        x = state.xMeters();
        y = state.yMeters();
        heading = state.headingRadians();
        setSpeeds(state.speedMetersPerSecond(), state.turnRadiansPerSecond());
        machine = new StatusMachine(state.status());
        autonomy.show(state.behaviour());
        odometry.restore(state.odometryXMeters(), state.odometryYMeters(), state.odometryHeadingRadians());
        floor.placed(this);
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

    /** Speed of the wheels, metres per second ahead. */
    public double speedMetersPerSecond() {
        return speed;
    }

    /** Turning speed of the wheels, anticlockwise. */
    public double turnRadiansPerSecond() {
        return 0 - turnSpeed;
    }

    /** The true pose, its heading in [0, 360), rounded to 1 nm and 1e-9 degrees. */
    @Override
    public Pose pose() {
        return PoseRounding.pose(x, y, heading);
    }

    /** The pose by its wheels. */
    public Odometry odometry() {
        return odometry;
    }

    /** Sets the odometry to 0. */
    public void resetOdometry() {
        odometry.reset();
        odometryZero = pose();
    }

    /** The bumpers that are pressed. */
    public Bumpers bumpers() {
        return Bumpers.pressed(this, floor, touch);
    }

    @Override
    public boolean hasLowBattery() {
        return battery.isLow();
    }

    public Battery battery() {
        return battery;
    }

    /** What its controller measures. */
    public Condition condition() {
        return new Condition(
                battery.volts(),
                hasLowBattery(),
                status() == RobotStatus.COLLISION,
                bumpers(),
                PoseRounding.pose(odometry.xMeters(), odometry.yMeters(), odometry.headingRadians()),
                odometryZero);
    }

    Noise noise() {
        return noise;
    }

    /** Sets the errors of wheels and sonars. */
    public void setNoise(Noise newNoise) {
        noise = newNoise;
    }

    /** Its path, for drawing. */
    public Trail trail() {
        return trail;
    }

    Sonars sonars() {
        return sonars;
    }

    /** Where it is or was at a moment of the sonar clock. */
    public double xMetersAt(int moment) {
        return moment == SonarClock.NOW ? x : sonars.xMeters(moment);
    }

    /** As {@link #xMetersAt}. */
    public double yMetersAt(int moment) {
        return moment == SonarClock.NOW ? y : sonars.yMeters(moment);
    }

    /** As {@link #xMetersAt}; not wrapped. */
    public double headingRadiansAt(int moment) {
        return moment == SonarClock.NOW ? heading : sonars.headingRadians(moment);
    }

    /** What the sixteen sonars measured when they last fired, metres, sonar 0 first. */
    public double[] sonarRangesMeters() {
        double[] ranges = new double[SonarRing.COUNT];
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = sonarRangeMeters(i);
        }
        return ranges;
    }

    /** What the laser measures now, metres: 181 readings from 90 degrees at the right to 90 degrees at the left. */
    public double[] laserRangesMeters() {
        return laserRangesMeters(LaserField.USUAL);
    }

    /** Whether windows show what the laser measures. */
    public boolean isLaserOn() {
        return laserOn;
    }

    /** Switches the laser; off, it can be read nevertheless. */
    public void setLaserOn(boolean on) {
        laserOn = on;
    }

    /** The same over another field. */
    public double[] laserRangesMeters(LaserField field) {
        return IntStream.range(0, field.count())
                .mapToDouble(reading -> Laser.rangeMeters(this, floor, field.radians(reading)))
                .toArray();
    }

    /** What one sonar measured when it last fired, noise included. */
    double sonarRangeMeters(int sonar) {
        return sonars.rangeMeters(sonar);
    }

    /** What the laser measures now, without noise: 0 to 32 m. @param reading 0 to 180, anticlockwise, 90 ahead */
    double laserRangeMeters(int reading) {
        if (reading < 0 || reading >= Senses.LASER_READINGS) {
            throw new IndexOutOfBoundsException("laser reading " + reading + ", expected 0 to 180");
        }
        return Laser.rangeMeters(this, floor, LaserField.USUAL.radians(reading));
    }

    /** The same in whole millimetres. */
    @Override
    public int[] sonarRangesMillimeters() {
        return Arrays.stream(sonarRangesMeters())
                .mapToInt(meters -> (int) Math.round(meters * 1000))
                .toArray();
    }
}
