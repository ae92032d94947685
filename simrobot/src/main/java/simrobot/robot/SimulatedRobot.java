package simrobot.robot;

import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import simrobot.world.Contact;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.Pose;
import vericommand.Robot;
import vericommand.RobotStatus;
import vericommand.StatusEvent;
import vericommand.StatusMachine;
import vericommand.StatusTable;

/**
 * A Pioneer 2-DX on a floor. It moves only in {@link #step}; everything happens on the simulation's owner thread.
 *
 * <p>A step takes the wheels' stretch of way from the motion's profile and the belt's from the floor, sweeps the robot's
 * circle along both, and stops it at the first contact. Goals are judged by the true place, so wheels that slip go on.
 */
public final class SimulatedRobot implements Robot {
    /** A turn made in Collision frees the robot when this much of the way ahead is free. */
    private static final double FREE_WAY_METERS = 0.01;

    private final String name;
    private final Floor floor;
    private final StatusMachine machine = new StatusMachine(RobotStatus.STOPPED);
    private final List<Consumer<RobotStatus>> statusListeners = new CopyOnWriteArrayList<>();
    private final List<Runnable> firstMotionListeners = new CopyOnWriteArrayList<>();
    private final Trail trail = new Trail();
    private double x;
    private double y;
    private double heading;

    /** Of the wheels: metres per second ahead. */
    private double speed;

    /** Of the wheels: radians per second clockwise. */
    private double turnSpeed;

    private Errand errand;
    private boolean errandHasMoved;

    private final DrivenMotion driven;
    private final Odometry odometry = new Odometry();
    private Touch touch = Touch.NONE;

    /** A robot that stands there with power and motors on. */
    public SimulatedRobot(String name, Floor floor, double xMeters, double yMeters, double headingRadians) {
        this.name = Objects.requireNonNull(name);
        this.floor = Objects.requireNonNull(floor);
        x = xMeters;
        y = yMeters;
        heading = headingRadians;
        driven = new DrivenMotion(this, floor);
    }

    public String name() {
        return name;
    }

    @Override
    public RobotStatus status() {
        return machine.status();
    }

    /** Told the new status at every change, on the owner thread, before a motion's outcome. */
    public void addStatusListener(Consumer<RobotStatus> listener) {
        statusListeners.add(listener);
    }

    /** Told at the end of the step in which the wheels first move for a motion, on the owner thread. */
    public void addFirstMotionListener(Runnable listener) {
        firstMotionListeners.add(listener);
    }

    // ---- switches ------------------------------------------------------------------------------------------------

    public boolean isPowered() {
        return status() != RobotStatus.DISCONNECTED;
    }

    public boolean hasMotors() {
        return isPowered() && status() != RobotStatus.NO_MOTORS;
    }

    /** Throws the power switch; on leaves the motors off. Off ends a motion at once. */
    public void setPower(boolean on) {
        if (on != isPowered()) {
            cut(on ? StatusEvent.POWER_ON : StatusEvent.POWER_OFF);
        }
    }

    /** Throws the motors' switch; without power nothing happens. Off ends a motion at once. */
    public void setMotors(boolean on) {
        if (isPowered() && on != hasMotors()) {
            cut(on ? StatusEvent.MOTORS_ON : StatusEvent.MOTORS_OFF);
        }
    }

    private void cut(StatusEvent event) {
        Errand cutShort = takeErrand();
        change(event);
        if (cutShort != null) {
            cutShort.end(MotionOutcome.Kind.ABORTED);
        }
    }

    // ---- motion --------------------------------------------------------------------------------------------------

    @Override
    public void start(Instruction.Motion motion, Consumer<MotionOutcome> ended) {
        Objects.requireNonNull(ended);
        if (StatusTable.treatment(status(), motion) != StatusTable.Treatment.EXECUTED) {
            throw new IllegalStateException(motion.keys() + " is not possible in " + status().text());
        }
        boolean inCollision = status() == RobotStatus.COLLISION;
        errand = new Errand(motion, ended, inCollision, x, y, heading);
        errandHasMoved = false;
        change(StatusEvent.MOTION_STARTED);
    }

    @Override
    public void brake() {
        if (errand != null) {
            errand.brake();
        }
        driven.drive().stop();
    }

    /** Stands still at once, without slowing down; an order under way ends as one that was braked. */
    public void brakeAtOnce() {
        Errand under = errand;
        stand();
        if (under != null) {
            under.brake();
            rest(under);
        } else if (status() == RobotStatus.MOVING) {
            driven.rest();
        }
    }

    /** True while it executes an instruction; its drive is not to be touched then. */
    public boolean isUnderOrder() {
        return errand != null;
    }

    /** For whoever steers directly: targets hold from the next step, if it has motors and is under no order. */
    public Drive drive() {
        return driven.drive();
    }

    /** Moves the robot through a step of simulated time. */
    public void step(long nanos) {
        double seconds = nanos * 1e-9;
        double beltX = floor.beltVelocityX(x, y) * seconds;
        double beltY = floor.beltVelocityY(x, y) * seconds;
        if (errand == null) {
            driven.step(seconds, beltX, beltY);
        } else if (errand.isForward()) {
            goForward(errand, seconds, beltX, beltY);
        } else {
            turn(errand, seconds, beltX, beltY);
        }
        if (errand != null) {
            tellFirstMotion();
            judge(errand, nanos);
        }
    }

    /** The belt takes the robot along until something stops it; that is no collision of the robot's own making. */
    void carry(double dx, double dy) {
        if (dx != 0 || dy != 0) {
            advance(dx, dy, floor.sweep(this, dx, dy).contact().fraction());
        }
    }

    private void goForward(Errand under, double seconds, double beltX, double beltY) {
        Trapezoid.Stretch stretch = under.next(speed, seconds);
        double wheelX = stretch.way() * under.aheadX();
        double wheelY = stretch.way() * under.aheadY();
        Floor.Encounter encounter = floor.sweep(this, wheelX + beltX, wheelY + beltY);
        Contact contact = encounter.contact();
        advance(wheelX + beltX, wheelY + beltY, contact.fraction());
        under.isAt(x, y);
        speed = stretch.speed();
        boolean wheelsPush = wheelX * contact.normalX() + wheelY * contact.normalY() < 0;
        boolean stopped = contact.touches() && wheelsPush;
        odometry.roll(stretch.way() * (stopped ? contact.fraction() : 1), 0);
        if (stopped) {
            touch(encounter);
        }
    }

    void touch(Floor.Encounter encounter) {
        Touch here = Touch.of(encounter.contact());
        touch(here);
        if (encounter.isRobot()) {
            encounter.robot().touch(here.opposite());
        }
    }

    private void turn(Errand under, double seconds, double beltX, double beltY) {
        Trapezoid.Stretch stretch = under.next(turnSpeed, seconds);
        under.hasTurnedBy(stretch.way());
        odometry.roll(0, -stretch.way());
        heading = stretch.speed() == 0 && under.isAtGoal() ? under.goalHeading() : heading - stretch.way();
        turnSpeed = stretch.speed();
        carry(beltX, beltY);
    }

    void advance(double dx, double dy, double share) {
        x += dx * share;
        y += dy * share;
        floor.moved(this);
    }

    /** A moving robot that touches something stands still at once. */
    private void touch(Touch here) {
        touch = here;
        if (errand != null) {
            finish(StatusEvent.TOUCHED, MotionOutcome.Kind.COLLISION);
        } else if (status() == RobotStatus.MOVING) {
            stand();
            change(StatusEvent.TOUCHED);
        }
    }

    private void stand() {
        driven.halt();
        speed = 0;
        turnSpeed = 0;
    }

    private void tellFirstMotion() {
        if (!errandHasMoved && (speed != 0 || turnSpeed != 0)) {
            errandHasMoved = true;
            firstMotionListeners.forEach(Runnable::run);
        }
    }

    private void judge(Errand under, long nanos) {
        boolean stands = speed == 0 && turnSpeed == 0;
        if (stands && (under.isAtGoal() || under.isBraking())) {
            rest(under);
        } else if (under.isOverdueAfter(nanos)) {
            finish(StatusEvent.MOTION_ENDED, MotionOutcome.Kind.INFINITE_LOOP);
        }
    }

    private void rest(Errand under) {
        boolean blocked = under.begunInCollision() && isWayBlocked();
        MotionOutcome.Kind well = under.isAtGoal() ? MotionOutcome.Kind.DONE : MotionOutcome.Kind.BRAKED;
        finish(
                blocked ? StatusEvent.TURN_ENDED_BLOCKED : StatusEvent.MOTION_ENDED,
                blocked && well == MotionOutcome.Kind.DONE ? MotionOutcome.Kind.COLLISION : well);
    }

    boolean isWayBlocked() {
        // a gap of exactly the free way, less the gap that contact leaves, counts as free
        return !isWayFree(FREE_WAY_METERS - 1e-6);
    }

    boolean isWayFree(double way) {
        return !floor.sweep(this, way * StrictMath.cos(heading), way * StrictMath.sin(heading))
                .contact()
                .touches();
    }

    private void finish(StatusEvent event, MotionOutcome.Kind kind) {
        Errand over = takeErrand();
        change(event);
        over.end(kind);
    }

    private Errand takeErrand() {
        Errand taken = errand;
        errand = null;
        stand();
        return taken;
    }

    void turnBy(double radians) {
        heading += radians;
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
        if (errand != null) {
            finish(StatusEvent.MOTION_ENDED, MotionOutcome.Kind.ABORTED);
        } else if (status() == RobotStatus.MOVING) {
            stand();
            change(StatusEvent.MOTION_ENDED);
        }
    }

    // ---- place ---------------------------------------------------------------------------------------------------

    /**
     * Puts the robot there by hand, standing. In Collision it comes free when the way ahead of it is free there, by the
     * rule that holds for a turn.
     */
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
        return Cleaned.pose(x, y, heading);
    }

    /** Where its wheels say that it is. */
    public Odometry odometry() {
        return odometry;
    }

    /** Where something presses on its body, anticlockwise from ahead, in (-pi, pi]; empty when nothing does. */
    public OptionalDouble touchBearingRadians() {
        return isTouching() ? OptionalDouble.of(touch.bearing(heading)) : OptionalDouble.empty();
    }

    /** The way that it has come, for drawing. */
    public Trail trail() {
        return trail;
    }

    // ---- sonar ---------------------------------------------------------------------------------------------------

    /** What the sixteen sonars hear now, metres, sonar 0 first. */
    public double[] sonarRangesMeters() {
        return Sonars.rangesMeters(this, floor);
    }

    /** The same in whole millimetres, 100 to 5000. */
    public int[] sonarRangesMillimeters() {
        return Sonars.rangesMillimeters(this, floor);
    }
}
