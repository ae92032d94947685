package simrobot.robot;

import java.util.List;
import java.util.SortedMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import simrobot.behaviour.Steering;
import simrobot.process.Surroundings;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.Pose;
import vericommand.Robot;
import vericommand.RobotStatus;
import vericommand.StatusEvent;
import vericommand.StatusMachine;
import vericommand.StatusRules;

/**
 * A Pioneer, simulated ({@link SimulatedRobot}) or real: its motions by telephone, its switches, its sensors, and its
 * {@link Autonomy}. Owned by the simulation's thread.
 */
public abstract class Pioneer implements Robot {
    private final String name;
    private final Autonomy autonomy = new Autonomy(this);
    private final List<Consumer<RobotStatus>> statusListeners = new CopyOnWriteArrayList<>();
    private final List<Runnable> firstMotionListeners = new CopyOnWriteArrayList<>();
    private final Trail trail = new Trail();
    private StatusMachine machine;

    protected Pioneer(String name, RobotStatus status) {
        this.name = name;
        setStatus(status);
    }

    public final String name() {
        return name;
    }

    // ---- status --------------------------------------------------------------------------------------------------

    @Override
    public final RobotStatus status() {
        return machine.status();
    }

    /** Adds a listener for the new status at every change, called on the owner thread before a motion's outcome. */
    public final void addStatusListener(Consumer<RobotStatus> listener) {
        statusListeners.add(listener);
    }

    /** Adds a listener called when the wheels first move for a motion, on the owner thread. */
    public final void addFirstMotionListener(Runnable listener) {
        firstMotionListeners.add(listener);
    }

    protected final void tellFirstMotion() {
        firstMotionListeners.forEach(Runnable::run);
    }

    /** Changes the status by a row of the table, and tells the listeners. */
    protected final void change(StatusEvent event) {
        RobotStatus status = machine.apply(event);
        statusListeners.forEach(listener -> listener.accept(status));
    }

    protected final boolean accepts(StatusEvent event) {
        return machine.accepts(event);
    }

    /** Sets the status without telling the listeners. */
    final void setStatus(RobotStatus status) {
        machine = new StatusMachine(status);
    }

    public final boolean isPowered() {
        return status() != RobotStatus.DISCONNECTED;
    }

    public final boolean hasMotors() {
        return isPowered() && status() != RobotStatus.NO_MOTORS;
    }

    /** Switches the power, or the link to a real robot. Off ends a motion at once. */
    public abstract void setPower(boolean on);

    /** Switches the motors; without power, does nothing. Off ends a motion at once. */
    public abstract void setMotors(boolean on);

    // ---- motion --------------------------------------------------------------------------------------------------

    @Override
    public final void start(Instruction.Motion motion, Consumer<MotionOutcome> ended) {
        if (StatusRules.treatment(status(), motion) != StatusRules.Treatment.EXECUTED) {
            throw new IllegalStateException(motion.keys() + " is not possible in " + status().text());
        }
        autonomy.end();
        begin(motion, ended);
    }

    /** Begins a motion that the current status permits. */
    protected abstract void begin(Instruction.Motion motion, Consumer<MotionOutcome> ended);

    /** True during a motion of an order. */
    protected abstract boolean isInMotion();

    /** True while it executes an instruction or brakes for one: its drive must not be used. */
    public final boolean isUnderOrder() {
        return isInMotion() || autonomy.isAwaited();
    }

    /** Moves the robot there by hand; of a real robot, records that a user has moved it there. */
    public final Placement place(double xMeters, double yMeters, double headingRadians) {
        return status() == RobotStatus.MOVING ? Placement.MOVING : put(xMeters, yMeters, headingRadians);
    }

    /** Places the robot; its status is not Moving. */
    protected abstract Placement put(double xMeters, double yMeters, double headingRadians);

    // ---- processes -----------------------------------------------------------------------------------------------

    /** Its autonomous process. */
    public final Autonomy autonomy() {
        return autonomy;
    }

    /** The surroundings known to its processes. */
    protected abstract Surroundings surroundings();

    /** Sets the wheels' target speeds. */
    protected abstract void steer(Steering steering);

    /** Brakes with the robot's deceleration. */
    protected abstract void stopSteering();

    @Override
    public final SortedMap<Integer, String> processes() {
        return autonomy.processes();
    }

    @Override
    public final void startProcess(int number, String operator) {
        autonomy.begin(number, operator);
    }

    @Override
    public final boolean takesKeys() {
        return autonomy.takesKeys();
    }

    @Override
    public final void pressKey(char key) {
        autonomy.call().press(key);
    }

    @Override
    public final boolean isAutonomous() {
        return autonomy.isActive();
    }

    @Override
    public final void endAutonomy(Runnable stands) {
        autonomy.endFor(stands);
    }

    /** Its path, for drawing. */
    public final Trail trail() {
        return trail;
    }

    // ---- senses --------------------------------------------------------------------------------------------------

    public abstract double xMeters();

    public abstract double yMeters();

    /** Anticlockwise from +X, not wrapped. */
    public abstract double headingRadians();

    /** The pose, its heading in [0, 360), rounded to 1 nm and 1e-9 degrees. */
    @Override
    public final Pose pose() {
        return PoseRounding.pose(xMeters(), yMeters(), headingRadians());
    }

    /** The pose by odometry, in its own frame; of a real robot, the pose. */
    protected Pose odometryPose() {
        return pose();
    }

    /** Speed of the wheels, metres per second ahead. */
    public abstract double speedMetersPerSecond();

    /** The pressed bumpers. */
    public abstract Bumpers bumpers();

    /** One sonar's latest range, 0.1 to 5 m, with noise. */
    public abstract double sonarMeters(int sonar);

    /**
     * The laser's range measured now by a simulated robot: 0 to 32 m.
     *
     * @param reading 0 to 180, anticlockwise, 90 ahead
     */
    public double laserMeters(int reading) {
        throw new UnsupportedOperationException("a real robot has no laser here, expected sonarMeters");
    }

    /** The ranges of the sixteen sonars, sonar 0 first. */
    public final double[] sonarRangesMeters() {
        return IntStream.range(0, SonarRing.COUNT)
                .mapToDouble(this::sonarMeters)
                .toArray();
    }

    /** The ranges of the sixteen sonars, 100 to 5000 mm, sonar 0 first. */
    public final int[] sonarRangesMillimeters() {
        return IntStream.range(0, SonarRing.COUNT)
                .map(sonar -> (int) Math.round(sonarMeters(sonar) * 1000))
                .toArray();
    }
}
