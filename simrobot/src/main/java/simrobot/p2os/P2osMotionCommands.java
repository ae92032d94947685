package simrobot.p2os;

import simrobot.robot.DirectControl;
import simrobot.robot.Drive;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SimulatedRobot;
import simrobot.robot.Trapezoid;

/**
 * Applies a client's motion commands to the robot's drive. While the robot executes an order by telephone, or its
 * motors are off, only stop commands take effect.
 */
final class P2osMotionCommands {
    private final SimulatedRobot robot;
    private final Drive drive;
    private final DirectControl control;

    P2osMotionCommands(SimulatedRobot robot) {
        this.robot = robot;
        drive = robot.drive();
        control = new DirectControl(robot);
    }

    DirectControl control() {
        return control;
    }

    /** Performs the command if it is a motion command. */
    void perform(P2osCommand command) {
        if (command instanceof P2osCommand.Stop) {
            robot.brake();
        } else if (command instanceof P2osCommand.EmergencyStop) {
            robot.brakeAtOnce();
        } else if (!limit(command) && control.take()) {
            steer(command);
        }
    }

    private void steer(P2osCommand command) {
        if (command instanceof P2osCommand.Velocity velocity) {
            drive.setSpeed(velocity.millimetersPerSecond() / 1000.0);
        } else if (command instanceof P2osCommand.Rotate rotate) {
            drive.setTurnSpeed(Math.toRadians(rotate.degreesPerSecond()));
        } else if (command instanceof P2osCommand.WheelVelocities wheels) {
            steerWheels(wheels);
        } else if (command instanceof P2osCommand.Move move) {
            drive.move(move.millimeters() / 1000.0);
        } else if (command instanceof P2osCommand.Heading heading) {
            double way = Math.toRadians(heading.degrees()) - robot.odometry().headingRadians();
            drive.turn(Math.IEEEremainder(way, 2 * Math.PI));
        } else if (command instanceof P2osCommand.TurnBy turn) {
            drive.turn(Math.toRadians(turn.degrees()));
        } else if (command instanceof P2osCommand.TurnByFromTarget turn) {
            drive.turn(drive.remainingTurn() + Math.toRadians(turn.degrees()));
        }
    }

    private void steerWheels(P2osCommand.WheelVelocities wheels) {
        double unit = P3dxScale.WHEEL_UNIT_MILLIMETERS_PER_SECOND / 1000;
        drive.setSpeed((wheels.left() + wheels.right()) * unit / 2);
        drive.setTurnSpeed((wheels.right() - wheels.left()) * unit / Pioneer2Dx.EFFECTIVE_TRACK_METERS);
    }

    /** Applies a limit; limits of 0 are ignored. Returns true if the command sets a limit. */
    private boolean limit(P2osCommand command) {
        Trapezoid ahead = drive.aheadLimits();
        Trapezoid turn = drive.turnLimits();
        if (command instanceof P2osCommand.Acceleration limit) {
            ahead = withAcceleration(ahead, limit.millimetersPerSecond2(), 0.001);
        } else if (command instanceof P2osCommand.TurnAcceleration limit) {
            turn = withAcceleration(turn, limit.degreesPerSecond2(), Math.toRadians(1));
        } else if (command instanceof P2osCommand.TopSpeed limit) {
            int top = Math.min(limit.millimetersPerSecond(), P3dxScale.MOST_MILLIMETERS_PER_SECOND);
            ahead = withTop(ahead, top / 1000.0);
        } else if (command instanceof P2osCommand.TopTurnSpeed limit) {
            turn = withTop(turn, Math.toRadians(Math.min(limit.degreesPerSecond(), P3dxScale.MOST_DEGREES_PER_SECOND)));
        } else {
            return false;
        }
        drive.setLimits(ahead, turn);
        return true;
    }

    private static Trapezoid withAcceleration(Trapezoid limits, int signed, double unit) {
        double size = Math.min(Math.abs(signed), P3dxScale.MOST_ACCELERATION) * unit;
        if (size == 0) {
            return limits;
        }
        return signed > 0
                ? new Trapezoid(limits.top(), size, limits.deceleration())
                : new Trapezoid(limits.top(), limits.acceleration(), size);
    }

    private static Trapezoid withTop(Trapezoid limits, double top) {
        return top > 0 ? new Trapezoid(top, limits.acceleration(), limits.deceleration()) : limits;
    }
}
