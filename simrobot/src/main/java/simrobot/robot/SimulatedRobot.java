package simrobot.robot;

import java.util.List;
import java.util.function.Consumer;
import simrobot.behaviour.Steering;
import simrobot.process.BehaviourKind;
import simrobot.process.Surroundings;
import simrobot.process.WaitBudget;
import simrobot.world.Position;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.Pose;
import vericommand.RobotStatus;
import vericommand.StatusEvent;

/**
 * A simulated Pioneer 2-DX. It moves only in {@link #step}; owned by the simulation's thread.
 *
 * <p>A step adds the wheels' distance by the motion's profile and the belt's by the floor, sweeps the robot's circle
 * along the sum, and stops it at the first contact. The true position decides about goals, so slipping wheels continue.
 */
public final class SimulatedRobot extends Pioneer implements Surroundings {
    /** Free distance ahead after which a turn made in Collision frees the robot. */
    private static final double FREE_PATH_METERS = 0.01;

    private final int number;
    private final Floor floor;
    private double x;
    private double y;
    private double heading;
    private final Rotation direction = new Rotation();
    /** Speed of the wheels, metres per second ahead. */
    private double speed;
    /** Turning speed by the wheels, radians per second clockwise. */
    private double turnSpeed;

    private final Wheels wheels;
    private final OrderedMotion ordered;
    private final DrivenMotion driven;
    private final Odometry odometry = new Odometry();
    private Pose odometryZero;
    private final Battery battery = new Battery();
    private ContactDirection touch = ContactDirection.NONE;
    private Noise noise = Noise.NONE;
    private final Sonars sonars;
    private final Laser laser;

    /**
     * Creates a robot at rest with power and motors on.
     *
     * @param number unique on the floor, from 0 in the order of addition
     */
    public SimulatedRobot(String name, int number, Floor floor, double xMeters, double yMeters, double headingRadians) {
        super(name, RobotStatus.STOPPED);
        this.number = number;
        this.floor = floor;
        x = xMeters;
        y = yMeters;
        heading = headingRadians;
        odometryZero = pose();
        laser = new Laser(this, floor);
        wheels = new Wheels(this, floor);
        ordered = new OrderedMotion(this, wheels);
        driven = new DrivenMotion(this, wheels);
        sonars = new Sonars(this, floor);
    }

    /** Switches the power; the motors stay off. Off ends a motion at once. */
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
        autonomy().end();
        ordered.finish(event, MotionOutcome.Ending.ABORTED);
    }

    // ---- motion --------------------------------------------------------------------------------------------------

    @Override
    protected void begin(Instruction.Motion motion, Consumer<MotionOutcome> ended) {
        ordered.begin(motion, ended);
    }

    @Override
    public void brake() {
        autonomy().end();
        ordered.brake();
        driven.drive().stop();
    }

    /** Stops at once, without deceleration; a motion of an order ends as braked. */
    public void brakeAtOnce() {
        autonomy().end();
        stand();
        if (ordered.isUnderWay()) {
            ordered.endBraked();
        } else if (status() == RobotStatus.MOVING) {
            driven.rest();
        }
    }

    @Override
    protected boolean isInMotion() {
        return ordered.isUnderWay();
    }

    /**
     * The drive, for direct control: targets take effect in the next step if the motors are on and no order is
     * executed.
     */
    public Drive drive() {
        return driven.drive();
    }

    @Override
    protected void steer(Steering steering) {
        drive().setSpeed(steering.metersPerSecond());
        drive().setTurnSpeed(steering.radiansPerSecond());
    }

    @Override
    protected void stopSteering() {
        drive().stop();
    }

    // ---- surroundings of its processes ---------------------------------------------------------------------------

    @Override
    protected Surroundings surroundings() {
        return this;
    }

    @Override
    public int robotNumber() {
        return number;
    }

    @Override
    public World world() {
        return floor.world();
    }

    @Override
    public List<Position> otherRobots() {
        return floor.others(this);
    }

    @Override
    public WaitBudget waitBudget() {
        return floor.waitBudget();
    }

    // ---- steps ---------------------------------------------------------------------------------------------------

    /** Moves the robot through a step of simulated time. */
    public void step(long nanos) {
        double seconds = nanos * 1e-9;
        autonomy().step(nanos);
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

    /** Stops a moving robot at a contact. */
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

    /** True if less than 1 cm of the path ahead is free, apart from the gap left by a contact. */
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

    /** True if the obstacle touched last is still there. */
    boolean isTouching() {
        return touch.persists(this, floor);
    }

    /** True if it is at rest, without an order or a process that may move it. */
    public boolean isAtRest() {
        return status() != RobotStatus.MOVING
                && speed == 0
                && turnSpeed == 0
                && !ordered.isUnderWay()
                && autonomy().kind() == BehaviourKind.NONE;
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

    /** Moves the robot there by hand. Collision becomes Stopped if the path ahead is free there, by the rule for turns. */
    @Override
    protected Placement put(double xMeters, double yMeters, double headingRadians) {
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
        trail().lift();
        if (status() == RobotStatus.COLLISION && !isPathBlocked()) {
            setStatus(RobotStatus.MOVING);
            change(StatusEvent.MOTION_ENDED);
        }
        return Placement.DONE;
    }

    /** Its observable state, to the last bit. */
    public RobotState state() {
        return RobotState.of(this);
    }

    /** Sets its state, for a replay: calls no listener, and does not move by itself. */
    public SimulatedRobot restore(RobotState state) {
        x = state.xMeters();
        y = state.yMeters();
        heading = state.headingRadians();
        setSpeeds(state.speedMetersPerSecond(), state.turnRadiansPerSecond());
        setStatus(state.status());
        autonomy().show(state.behaviour());
        odometry.set(state.odometryXMeters(), state.odometryYMeters(), state.odometryHeadingRadians());
        floor.placed(this);
        return this;
    }

    @Override
    public double xMeters() {
        return x;
    }

    @Override
    public double yMeters() {
        return y;
    }

    @Override
    public double headingRadians() {
        return heading;
    }

    @Override
    public double speedMetersPerSecond() {
        return speed;
    }

    /** Turning speed of the wheels, anticlockwise. */
    public double turnRadiansPerSecond() {
        return 0 - turnSpeed;
    }

    public Odometry odometry() {
        return odometry;
    }

    @Override
    protected Pose odometryPose() {
        return PoseRounding.pose(odometry.xMeters(), odometry.yMeters(), odometry.headingRadians());
    }

    /** Sets the odometry to 0. */
    public void resetOdometry() {
        odometry.set(0, 0, 0);
        odometryZero = pose();
    }

    @Override
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

    /** The controller's measurements. */
    public Condition condition() {
        return new Condition(
                battery.volts(),
                hasLowBattery(),
                status() == RobotStatus.COLLISION,
                bumpers(),
                odometryPose(),
                odometryZero);
    }

    Noise noise() {
        return noise;
    }

    /** Sets the errors of wheels, sonars and laser. */
    public void setNoise(Noise newNoise) {
        noise = newNoise;
    }

    /** Its sonars, which remember its positions at their firings. */
    public Sonars sonars() {
        return sonars;
    }

    public Laser laser() {
        return laser;
    }

    @Override
    public double sonarMeters(int sonar) {
        return sonars.rangeMeters(sonar);
    }

    @Override
    public double laserMeters(int reading) {
        return laser.rangeMeters(reading);
    }
}
