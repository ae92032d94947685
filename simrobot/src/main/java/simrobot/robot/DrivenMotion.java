package simrobot.robot;

import simrobot.world.Contact;
import vericommand.RobotStatus;
import vericommand.StatusEvent;

/**
 * Moves a robot by its {@link Drive}, along arcs, until an obstacle stops it, and updates the status: Moving while it is
 * driven, Collision when it touches something, Stopped when it comes to rest.
 */
final class DrivenMotion {
    /** Distance below which an obstacle is touched; far above the gap that a contact leaves. */
    private static final double TOUCH_METERS = 1e-6;

    private final SimulatedRobot robot;
    private final Floor floor;
    private final Drive drive = new Drive();
    private final Rotation direction = new Rotation();
    private final Arc arc = new Arc();
    private boolean begunInCollision;

    DrivenMotion(SimulatedRobot robot, Floor floor) {
        this.robot = robot;
        this.floor = floor;
    }

    Drive drive() {
        return drive;
    }

    /** Stops at once and clears all targets. */
    void halt() {
        drive.halt();
        begunInCollision = false;
    }

    void step(double seconds, double beltX, double beltY) {
        if (drive.isActive()) {
            clearBlockedTargets();
        }
        if (!drive.isActive()) {
            robot.carry(beltX, beltY);
            if (robot.status() == RobotStatus.MOVING && mayRest()) {
                rest();
            }
            return;
        }
        if (robot.status() != RobotStatus.MOVING) {
            begunInCollision = robot.status() == RobotStatus.COLLISION;
            robot.change(StatusEvent.MOTION_STARTED);
        }
        double meters = drive.nextAhead(seconds).distance();
        double radians = drive.nextTurn(seconds).distance();
        robot.setSpeeds(drive.speed(), drive.turnSpeed());
        if (roll(meters, radians, beltX, beltY) && !drive.isActive() && mayRest()) {
            rest();
        }
    }

    /** A process keeps its standing robot Moving, unless it began in Collision: whether it is free now has to be found. */
    private boolean mayRest() {
        return begunInCollision || !robot.autonomy().isUnfinished();
    }

    /** Clears all targets without motors, and in Collision a distance target against the obstacle. */
    private void clearBlockedTargets() {
        if (!robot.hasMotors()) {
            drive.halt();
        }
        boolean inCollision =
                robot.status() == RobotStatus.COLLISION || (robot.status() == RobotStatus.MOVING && begunInCollision);
        double towards = drive.startDirection();
        if (inCollision && towards != 0 && !robot.isPathFree(towards * TOUCH_METERS)) {
            drive.haltAhead();
        }
    }

    /** Moves along an arc in small chords; false if an obstacle has stopped the robot. */
    private boolean roll(double meters, double radians, double beltX, double beltY) {
        int chords = Arc.chords(meters, radians);
        double wheelTurn = radians / chords;
        double wheelDistance = meters / chords;
        double turn = wheelTurn * robot.noise().turnFactor();
        double distance = wheelDistance * robot.noise().distanceFactor();
        double chord = distance * arc.chordShare(turn);
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
            robot.odometry().roll(wheelDistance * share, wheelTurn * share);
            robot.advance(dx, dy, contact.fraction());
            if (stopped) {
                robot.touch(encounter);
                return false;
            }
        }
        return true;
    }

    /** The robot has come to rest; targets of a suspended drive are kept. */
    void rest() {
        boolean blocked = begunInCollision && robot.isTouching() && robot.isPathBlocked();
        begunInCollision = false;
        robot.setSpeeds(0, 0);
        robot.change(blocked ? StatusEvent.TURN_ENDED_BLOCKED : StatusEvent.MOTION_ENDED);
    }
}
