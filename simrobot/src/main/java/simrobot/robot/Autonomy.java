package simrobot.robot;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.BehaviourKind;
import simrobot.behaviour.Steering;
import vericommand.RobotStatus;

/**
 * The autonomous process in a robot: it steers the drive ten times a second until somebody ends it. An order, a client
 * that drives, whoever brakes, and the switches end it; ending brakes the robot, it does not stand at once.
 */
public final class Autonomy {
    private final SimulatedRobot robot;
    private final List<Consumer<BehaviourKind>> listeners = new CopyOnWriteArrayList<>();
    private BehaviourKind kind = BehaviourKind.NONE;
    private Optional<Behaviour> behaviour = Optional.empty();
    private long sinceDecisionNanos;
    /** Told when the robot stands; null when nobody waits for that. */
    private Runnable awaiting;

    Autonomy(SimulatedRobot robot) {
        this.robot = robot;
    }

    public BehaviourKind kind() {
        return kind;
    }

    public boolean isActive() {
        return behaviour.isPresent();
    }

    /** Told the new kind at every change, on the owner thread. */
    public void addListener(Consumer<BehaviourKind> listener) {
        listeners.add(listener);
    }

    /**
     * Begins a process in place of the one that runs; {@link BehaviourKind#NONE} only ends that one.
     *
     * @return false, and nothing has changed, when the robot has no motors or is under an order
     */
    public boolean begin(BehaviourKind next) {
        if (next == BehaviourKind.NONE) {
            end();
            return true;
        }
        if (!robot.hasMotors() || robot.isUnderOrder()) {
            return false;
        }
        become(next, next.begin(robot.number()));
        sinceDecisionNanos = Behaviour.TICK_NANOS;
        return true;
    }

    /** Looks as if it ran; for a replay. */
    void show(BehaviourKind shown) {
        kind = shown;
    }

    /** Ends the process, if one runs; the robot slows down to a stand. */
    public void end() {
        if (isActive()) {
            robot.drive().stop();
            become(BehaviourKind.NONE, Optional.empty());
        }
    }

    /** Ends the process for an order, which waits for the robot to stand. */
    void endFor(Runnable stands) {
        end();
        awaiting = stands;
        tellIfItStands();
    }

    boolean isAwaited() {
        return awaiting != null;
    }

    private void tellIfItStands() {
        if (awaiting != null && robot.status() != RobotStatus.MOVING) {
            Runnable told = awaiting;
            awaiting = null;
            told.run();
        }
    }

    private void become(BehaviourKind next, Optional<Behaviour> process) {
        boolean changes = next != kind;
        kind = next;
        behaviour = process;
        if (changes) {
            listeners.forEach(listener -> listener.accept(next));
        }
    }

    /** A step of time, before the robot moves through it. */
    void step(long nanos) {
        tellIfItStands();
        if (behaviour.isPresent()) {
            sinceDecisionNanos += nanos;
            if (sinceDecisionNanos >= Behaviour.TICK_NANOS) {
                sinceDecisionNanos -= Behaviour.TICK_NANOS;
                Steering steering =
                        behaviour.get().decide(robot::sonarRangeMeters, robot.status() == RobotStatus.COLLISION);
                robot.drive().setSpeed(steering.metersPerSecond());
                robot.drive().setTurnSpeed(steering.radiansPerSecond());
            }
        }
    }
}
