package simrobot.robot;

import java.util.function.Consumer;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.RobotStatus;
import vericommand.StatusEvent;

/** Executes the instructions of an order on a robot, one at a time. The true position decides about goals. */
final class OrderedMotion {
    private final SimulatedRobot robot;
    private final Wheels wheels;
    private MotionProgress motion;
    private boolean hasMoved;

    OrderedMotion(SimulatedRobot robot, Wheels wheels) {
        this.robot = robot;
        this.wheels = wheels;
    }

    boolean isUnderWay() {
        return motion != null;
    }

    void begin(Instruction.Motion instruction, Consumer<MotionOutcome> ended) {
        boolean inCollision = robot.status() == RobotStatus.COLLISION;
        motion = new MotionProgress(robot, instruction, ended, inCollision);
        hasMoved = false;
        robot.change(StatusEvent.MOTION_STARTED);
    }

    /** Decelerates from the next step. */
    void brake() {
        if (motion != null) {
            motion.brake();
        }
    }

    /** Ends the motion of a robot at rest as a braked one. */
    void endBraked() {
        motion.brake();
        rest();
    }

    void step(long nanos) {
        double seconds = nanos * 1e-9;
        Floor.Encounter encounter = motion.isForward() ? goForward(seconds) : turn(seconds);
        if (encounter != null) {
            robot.touch(encounter);
        }
        if (motion != null) {
            notifyFirstMotion();
            checkEnd(nanos);
        }
    }

    private Floor.Encounter goForward(double seconds) {
        Trapezoid.Step step = motion.next(robot.speedMetersPerSecond(), seconds);
        double factor = robot.noise().distanceFactor();
        Floor.Encounter encounter = wheels.roll(step.distance() / factor, 0, factor, 1);
        robot.setSpeeds(step.speed(), robot.turnRadiansPerSecond());
        return encounter;
    }

    private Floor.Encounter turn(double seconds) {
        Trapezoid.Step step = motion.next(0 - robot.turnRadiansPerSecond(), seconds);
        double factor = robot.noise().turnFactor();
        Floor.Encounter encounter = wheels.roll(0, -step.distance() / factor, 1, factor);
        if (step.speed() == 0 && motion.isAtGoal()) {
            robot.turnTo(motion.goalHeading());
        }
        robot.setSpeeds(robot.speedMetersPerSecond(), 0 - step.speed());
        return encounter;
    }

    private boolean isStanding() {
        return robot.speedMetersPerSecond() == 0 && robot.turnRadiansPerSecond() == 0;
    }

    private void notifyFirstMotion() {
        if (!hasMoved && !isStanding()) {
            hasMoved = true;
            robot.tellFirstMotion();
        }
    }

    private void checkEnd(long nanos) {
        if (isStanding() && (motion.isAtGoal() || motion.isBraking())) {
            rest();
        } else if (motion.isInfiniteLoopAfter(nanos)) {
            finish(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.INFINITE_LOOP);
        }
    }

    private void rest() {
        boolean blocked = motion.begunInCollision() && robot.isPathBlocked();
        MotionOutcome.Ending unblocked = motion.isAtGoal() ? MotionOutcome.Ending.DONE : MotionOutcome.Ending.BRAKED;
        finish(
                blocked ? StatusEvent.TURN_ENDED_BLOCKED : StatusEvent.MOTION_ENDED,
                blocked && unblocked == MotionOutcome.Ending.DONE ? MotionOutcome.Ending.COLLISION : unblocked);
    }

    /** Stops the robot, changes its status, then reports the end of the motion. */
    void finish(StatusEvent event, MotionOutcome.Ending kind) {
        MotionProgress ended = motion;
        motion = null;
        robot.stand();
        robot.change(event);
        if (ended != null) {
            ended.end(kind);
        }
    }
}
