package simrobot.robot;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import simrobot.world.Contact;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.RobotStatus;
import vericommand.StatusEvent;

/** Executes the instructions of an order on a robot, one at a time. Goals are judged by the true place. */
final class OrderedMotion {
    private final SimulatedRobot robot;
    private final Floor floor;
    private final List<Runnable> firstMotionListeners = new CopyOnWriteArrayList<>();
    private MotionProgress motion;
    private boolean hasMoved;

    OrderedMotion(SimulatedRobot robot, Floor floor) {
        this.robot = robot;
        this.floor = floor;
    }

    void addFirstMotionListener(Runnable listener) {
        firstMotionListeners.add(listener);
    }

    boolean isUnderWay() {
        return motion != null;
    }

    void begin(Instruction.Motion instruction, Consumer<MotionOutcome> ended) {
        boolean inCollision = robot.status() == RobotStatus.COLLISION;
        motion = new MotionProgress(
                instruction, ended, inCollision, robot.xMeters(), robot.yMeters(), robot.headingRadians());
        hasMoved = false;
        robot.change(StatusEvent.MOTION_STARTED);
    }

    /** Slows down from the next step on. */
    void brake() {
        if (motion != null) {
            motion.brake();
        }
    }

    /** Ends a motion of a robot that stands already, as one that was braked. */
    void endBraked() {
        motion.brake();
        rest();
    }

    void step(long nanos, double beltX, double beltY) {
        double seconds = nanos * 1e-9;
        if (motion.isForward()) {
            goForward(seconds, beltX, beltY);
        } else {
            turn(seconds, beltX, beltY);
        }
        if (motion != null) {
            notifyFirstMotion();
            checkEnd(nanos);
        }
    }

    private void goForward(double seconds, double beltX, double beltY) {
        MotionProgress current = motion;
        Trapezoid.Step step = current.next(robot.speedMetersPerSecond(), seconds);
        double wheelX = step.distance() * current.aheadX();
        double wheelY = step.distance() * current.aheadY();
        Floor.Encounter encounter = floor.sweep(robot, wheelX + beltX, wheelY + beltY);
        Contact contact = encounter.contact();
        robot.advance(wheelX + beltX, wheelY + beltY, contact.fraction());
        current.setPlace(robot.xMeters(), robot.yMeters());
        robot.setSpeeds(step.speed(), robot.turnRadiansPerSecond());
        boolean isPushing = wheelX * contact.normalX() + wheelY * contact.normalY() < 0;
        boolean stopped = contact.touches() && isPushing;
        robot.odometry()
                .roll(
                        step.distance()
                                * (stopped ? contact.fraction() : 1)
                                / robot.noise().distanceFactor(),
                        0);
        if (stopped) {
            robot.touch(encounter);
        }
    }

    private void turn(double seconds, double beltX, double beltY) {
        Trapezoid.Step step = motion.next(0 - robot.turnRadiansPerSecond(), seconds);
        motion.addTurn(step.distance());
        robot.odometry().roll(0, -step.distance() / robot.noise().turnFactor());
        if (step.speed() == 0 && motion.isAtGoal()) {
            robot.turnTo(motion.goalHeading());
        } else {
            robot.turnBy(-step.distance());
        }
        robot.setSpeeds(robot.speedMetersPerSecond(), 0 - step.speed());
        robot.carry(beltX, beltY);
    }

    private boolean isStanding() {
        return robot.speedMetersPerSecond() == 0 && robot.turnRadiansPerSecond() == 0;
    }

    private void notifyFirstMotion() {
        if (!hasMoved && !isStanding()) {
            hasMoved = true;
            firstMotionListeners.forEach(Runnable::run);
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
