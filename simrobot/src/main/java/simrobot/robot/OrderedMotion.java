package simrobot.robot;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import simrobot.world.Contact;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.RobotStatus;
import vericommand.StatusEvent;

/** Moves a robot through the instructions of an order, one at a time; goals are judged by the true place. */
final class OrderedMotion {
    private final SimulatedRobot robot;
    private final Floor floor;
    private final List<Runnable> firstMotionListeners = new CopyOnWriteArrayList<>();
    private MotionProgress errand;
    private boolean hasMoved;

    OrderedMotion(SimulatedRobot robot, Floor floor) {
        this.robot = robot;
        this.floor = floor;
    }

    void addFirstMotionListener(Runnable listener) {
        firstMotionListeners.add(listener);
    }

    boolean isUnderWay() {
        return errand != null;
    }

    void begin(Instruction.Motion motion, Consumer<MotionOutcome> ended) {
        boolean inCollision = robot.status() == RobotStatus.COLLISION;
        errand = new MotionProgress(
                motion, ended, inCollision, robot.xMeters(), robot.yMeters(), robot.headingRadians());
        hasMoved = false;
        robot.change(StatusEvent.MOTION_STARTED);
    }

    /** The wheels slow down from the next step on. */
    void brake() {
        if (errand != null) {
            errand.brake();
        }
    }

    /** Ends as one that was braked; the robot stands already. */
    void endBraked() {
        errand.brake();
        rest();
    }

    void step(long nanos, double beltX, double beltY) {
        double seconds = nanos * 1e-9;
        if (errand.isForward()) {
            goForward(seconds, beltX, beltY);
        } else {
            turn(seconds, beltX, beltY);
        }
        if (errand != null) {
            tellFirstMotion();
            judge(nanos);
        }
    }

    private void goForward(double seconds, double beltX, double beltY) {
        MotionProgress under = errand;
        Trapezoid.Stretch stretch = under.next(robot.speedMetersPerSecond(), seconds);
        double wheelX = stretch.way() * under.aheadX();
        double wheelY = stretch.way() * under.aheadY();
        Floor.Encounter encounter = floor.sweep(robot, wheelX + beltX, wheelY + beltY);
        Contact contact = encounter.contact();
        robot.advance(wheelX + beltX, wheelY + beltY, contact.fraction());
        under.isAt(robot.xMeters(), robot.yMeters());
        robot.runsAt(stretch.speed(), robot.turnRadiansPerSecond());
        boolean wheelsPush = wheelX * contact.normalX() + wheelY * contact.normalY() < 0;
        boolean stopped = contact.touches() && wheelsPush;
        robot.odometry()
                .roll(
                        stretch.way()
                                * (stopped ? contact.fraction() : 1)
                                / robot.noise().way(),
                        0);
        if (stopped) {
            robot.touch(encounter);
        }
    }

    private void turn(double seconds, double beltX, double beltY) {
        Trapezoid.Stretch stretch = errand.next(0 - robot.turnRadiansPerSecond(), seconds);
        errand.hasTurnedBy(stretch.way());
        robot.odometry().roll(0, -stretch.way() / robot.noise().turn());
        if (stretch.speed() == 0 && errand.isAtGoal()) {
            robot.turnTo(errand.goalHeading());
        } else {
            robot.turnBy(-stretch.way());
        }
        robot.runsAt(robot.speedMetersPerSecond(), 0 - stretch.speed());
        robot.carry(beltX, beltY);
    }

    private boolean stands() {
        return robot.speedMetersPerSecond() == 0 && robot.turnRadiansPerSecond() == 0;
    }

    private void tellFirstMotion() {
        if (!hasMoved && !stands()) {
            hasMoved = true;
            firstMotionListeners.forEach(Runnable::run);
        }
    }

    private void judge(long nanos) {
        if (stands() && (errand.isAtGoal() || errand.isBraking())) {
            rest();
        } else if (errand.isOverdueAfter(nanos)) {
            finish(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.INFINITE_LOOP);
        }
    }

    private void rest() {
        boolean blocked = errand.begunInCollision() && robot.isWayBlocked();
        MotionOutcome.Ending well = errand.isAtGoal() ? MotionOutcome.Ending.DONE : MotionOutcome.Ending.BRAKED;
        finish(
                blocked ? StatusEvent.TURN_ENDED_BLOCKED : StatusEvent.MOTION_ENDED,
                blocked && well == MotionOutcome.Ending.DONE ? MotionOutcome.Ending.COLLISION : well);
    }

    /** The robot stands; the status changes, then the order hears of it. */
    void finish(StatusEvent event, MotionOutcome.Ending kind) {
        MotionProgress over = errand;
        errand = null;
        robot.stand();
        robot.change(event);
        if (over != null) {
            over.end(kind);
        }
    }
}
