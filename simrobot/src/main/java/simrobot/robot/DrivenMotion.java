package simrobot.robot;

import vericommand.RobotStatus;
import vericommand.StatusEvent;

/**
 * Moves a robot by its {@link Drive}, along arcs, until an obstacle stops it, and updates the status: Moving while
 * driven, Collision at a contact, Stopped at rest.
 */
final class DrivenMotion {
    /** Distance that counts as contact; far above the gap left by a contact. */
    private static final double TOUCH_METERS = 1e-6;

    private final SimulatedRobot robot;
    private final Wheels wheels;
    private final Drive drive = new Drive();
    private boolean begunInCollision;

    DrivenMotion(SimulatedRobot robot, Wheels wheels) {
        this.robot = robot;
        this.wheels = wheels;
    }

    Drive drive() {
        return drive;
    }

    /** Stops at once and clears all targets. */
    void halt() {
        drive.halt();
        begunInCollision = false;
    }

    void step(double seconds) {
        if (drive.isActive()) {
            clearBlockedTargets();
        }
        if (!drive.isActive()) {
            wheels.carry();
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
        // the turn's random number precedes the distance's
        double turnFactor = robot.noise().turnFactor();
        Floor.Encounter encounter = wheels.roll(meters, radians, robot.noise().distanceFactor(), turnFactor);
        if (encounter != null) {
            robot.touch(encounter);
        } else if (!drive.isActive() && mayRest()) {
            rest();
        }
    }

    /** A process keeps its robot Moving at rest, unless it began in Collision and the path may be free now. */
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

    /** Handles the robot's coming to rest; targets of a suspended drive are kept. */
    void rest() {
        boolean blocked = begunInCollision && robot.isTouching() && robot.isPathBlocked();
        begunInCollision = false;
        robot.setSpeeds(0, 0);
        robot.change(blocked ? StatusEvent.TURN_ENDED_BLOCKED : StatusEvent.MOTION_ENDED);
    }
}
