package simrobot.robot;

import simrobot.world.Contact;
import vericommand.RobotStatus;
import vericommand.StatusEvent;

/**
 * Moves a robot as its {@link Drive} wants, along arcs, until something stops it; keeps the status machine in step: who
 * is driven is Moving, who touches something is in Collision, who comes to rest is Stopped.
 */
final class DrivenMotion {
    /** Nearer is touching; far above the gap that a contact leaves. */
    private static final double TOUCH_METERS = 1e-6;

    private final SimulatedRobot robot;
    private final Floor floor;
    private final Drive drive = new Drive();
    private final Direction direction = new Direction();
    private boolean begunInCollision;

    DrivenMotion(SimulatedRobot robot, Floor floor) {
        this.robot = robot;
        this.floor = floor;
    }

    Drive drive() {
        return drive;
    }

    /** Stands at once, all targets forgotten. */
    void halt() {
        drive.halt();
        begunInCollision = false;
    }

    void step(double seconds, double beltX, double beltY) {
        if (drive.isActive()) {
            forgetTheImpossible();
        }
        if (!drive.isActive()) {
            robot.carry(beltX, beltY);
            if (robot.status() == RobotStatus.MOVING) {
                rest();
            }
            return;
        }
        if (robot.status() != RobotStatus.MOVING) {
            begunInCollision = robot.status() == RobotStatus.COLLISION;
            robot.change(StatusEvent.MOTION_STARTED);
        }
        double meters = drive.nextAhead(seconds).way();
        double radians = drive.nextTurn(seconds).way();
        robot.runsAt(drive.speed(), drive.turnSpeed());
        if (roll(meters, radians, beltX, beltY) && !drive.isActive()) {
            rest();
        }
    }

    /** Without motors nothing moves; who has collided may turn and back away, but not push on. */
    private void forgetTheImpossible() {
        if (!robot.hasMotors()) {
            drive.halt();
        }
        boolean inCollision =
                robot.status() == RobotStatus.COLLISION || (robot.status() == RobotStatus.MOVING && begunInCollision);
        double sense = drive.setsOut();
        if (inCollision && sense != 0 && !robot.isWayFree(sense * TOUCH_METERS)) {
            drive.forgetWay();
        }
    }

    /** Goes along an arc in small chords; false when something has stopped it. */
    private boolean roll(double meters, double radians, double beltX, double beltY) {
        int chords = Arc.chords(meters, radians);
        double wheelTurn = radians / chords;
        double wheelWay = meters / chords;
        double turn = wheelTurn * robot.noise().turn();
        double way = wheelWay * robot.noise().way();
        double chord = way * Arc.chordShare(turn);
        for (int i = 0; i < chords; i++) {
            direction.to(robot.headingRadians() + turn / 2);
            double wheelX = chord * direction.cos();
            double wheelY = chord * direction.sin();
            double dx = wheelX + beltX / chords;
            double dy = wheelY + beltY / chords;
            Floor.Encounter encounter = dx == 0 && dy == 0 ? Floor.Encounter.NONE : floor.sweep(robot, dx, dy);
            Contact contact = encounter.contact();
            boolean stopped = contact.touches() && wheelX * contact.normalX() + wheelY * contact.normalY() < 0;
            double share = stopped ? contact.fraction() : 1;
            robot.turnBy(turn * share);
            robot.odometry().roll(wheelWay * share, wheelTurn * share);
            robot.advance(dx, dy, contact.fraction());
            if (stopped) {
                robot.touch(encounter);
                return false;
            }
        }
        return true;
    }

    /** The robot stands; targets of a suspended drive are kept. */
    void rest() {
        boolean blocked = begunInCollision && robot.isTouching() && robot.isWayBlocked();
        begunInCollision = false;
        robot.runsAt(0, 0);
        robot.change(blocked ? StatusEvent.TURN_ENDED_BLOCKED : StatusEvent.MOTION_ENDED);
    }
}
