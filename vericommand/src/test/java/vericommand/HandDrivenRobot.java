package vericommand;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;

/** A robot that moves when the test says so. */
final class HandDrivenRobot implements Robot {
    final StatusMachine machine;
    final List<Instruction.Motion> started = new ArrayList<>();
    final List<Integer> processes = new ArrayList<>();
    Pose pose = new Pose(1.2, 0.5, 90);
    int brakes;
    boolean autonomous;
    Optional<String> unknownType = Optional.empty();
    int autonomyEnds;
    private Consumer<MotionOutcome> ended;
    private Runnable standing;

    HandDrivenRobot(RobotStatus status) {
        machine = new StatusMachine(status);
    }

    @Override
    public RobotStatus status() {
        return machine.status();
    }

    @Override
    public void start(Instruction.Motion motion, Consumer<MotionOutcome> whenEnded) {
        if (StatusRules.treatment(status(), motion) != StatusRules.Treatment.EXECUTED) {
            throw new IllegalStateException(motion + " in " + status());
        }
        machine.apply(StatusEvent.MOTION_STARTED);
        started.add(motion);
        ended = whenEnded;
    }

    /** The processes by number; a test may add some. */
    final SortedMap<Integer, String> available = new TreeMap<>(Map.of(1, "wander", 2, "wall-follow"));

    @Override
    public void brake() {
        brakes++;
    }

    @Override
    public Optional<String> unknownType() {
        return unknownType;
    }

    @Override
    public boolean isAutonomous() {
        return autonomous;
    }

    @Override
    public void endAutonomy(Runnable whenStanding) {
        autonomous = false;
        autonomyEnds++;
        standing = whenStanding;
    }

    @Override
    public SortedMap<Integer, String> processes() {
        return available;
    }

    @Override
    public void startProcess(int number, String operator) {
        machine.apply(StatusEvent.MOTION_STARTED);
        autonomous = true;
        processes.add(number);
    }

    /** The autonomous behaviour has ended and the robot has come to rest by this event. */
    void standAfterAutonomy(StatusEvent event) {
        machine.apply(event);
        standing.run();
    }

    @Override
    public Pose pose() {
        return pose;
    }

    /** The motion under way ends by this event. */
    void end(StatusEvent event, MotionOutcome.Ending ending, double amountDone) {
        machine.apply(event);
        Consumer<MotionOutcome> receiver = ended;
        ended = null;
        receiver.accept(new MotionOutcome(ending, amountDone));
    }

    void reachGoal() {
        end(
                StatusEvent.MOTION_ENDED,
                MotionOutcome.Ending.DONE,
                started.get(started.size() - 1).amount());
    }

    void collide(double amountDone) {
        end(StatusEvent.TOUCHED, MotionOutcome.Ending.COLLISION, amountDone);
    }

    /** The brake stops it. */
    void stand(double amountDone) {
        end(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.BRAKED, amountDone);
    }
}
