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
 * The autonomous process in a robot: it sets the drive's speeds ten times a second until it is ended by an order, a P2OS
 * client's motion command, a brake or a switch. Ending it brakes the robot with its deceleration.
 */
public final class Autonomy {
    private final SimulatedRobot robot;
    private final List<Consumer<BehaviourKind>> listeners = new CopyOnWriteArrayList<>();
    private BehaviourKind kind = BehaviourKind.NONE;
    private Optional<Behaviour> behaviour = Optional.empty();
    private long sinceDecisionNanos;
    /** Called once the robot stands; null if no order waits for that. */
    private Runnable standListener;

    Autonomy(SimulatedRobot robot) {
        this.robot = robot;
    }

    public BehaviourKind kind() {
        return kind;
    }

    public boolean isActive() {
        return behaviour.isPresent();
    }

    /** Adds a listener for the new kind at every change, on the owner thread. */
    public void addListener(Consumer<BehaviourKind> listener) {
        listeners.add(listener);
    }

    /**
     * Begins a process in place of the running one; {@link BehaviourKind#NONE} only ends that.
     *
     * @return false, with nothing changed, if the robot has no motors or executes an order
     */
    public boolean begin(BehaviourKind next) {
        if (next == BehaviourKind.NONE) {
            end();
            return true;
        }
        if (!robot.hasMotors() || robot.isUnderOrder()) {
            return false;
        }
        change(next, next.begin(robot.number()));
        sinceDecisionNanos = Behaviour.TICK_NANOS;
        return true;
    }

    /** Sets the kind that is shown, for a replay; no process runs. */
    void show(BehaviourKind shown) {
        kind = shown;
    }

    /** Ends the process, if one runs; the robot slows down until it stands. */
    public void end() {
        if (isActive()) {
            robot.drive().stop();
            change(BehaviourKind.NONE, Optional.empty());
        }
    }

    /** Ends the process for an order. @param listener called once the robot stands */
    void endFor(Runnable listener) {
        end();
        standListener = listener;
        notifyIfStanding();
    }

    boolean isAwaited() {
        return standListener != null;
    }

    private void notifyIfStanding() {
        if (standListener != null && robot.status() != RobotStatus.MOVING) {
            Runnable listener = standListener;
            standListener = null;
            listener.run();
        }
    }

    private void change(BehaviourKind next, Optional<Behaviour> process) {
        boolean changes = next != kind;
        kind = next;
        behaviour = process;
        if (changes) {
            listeners.forEach(listener -> listener.accept(next));
        }
    }

    /** A step of time, before the robot moves through it. */
    void step(long nanos) {
        notifyIfStanding();
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
