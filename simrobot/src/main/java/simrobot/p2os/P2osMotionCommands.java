package simrobot.p2os;

import java.util.Optional;
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
    void perform(int number, int argument) {
        Trapezoid ahead = drive.aheadLimits();
        Trapezoid turn = drive.turnLimits();
        switch (number) {
            case P2osCommandNumber.SETA -> drive.setLimits(withAcceleration(ahead, argument, 0.001), turn);
            case P2osCommandNumber.SETRA -> drive.setLimits(ahead, withAcceleration(turn, argument, Math.toRadians(1)));
            case P2osCommandNumber.SETV -> {
                int top = Math.min(argument, P3dxScale.MOST_MILLIMETERS_PER_SECOND);
                drive.setLimits(withTop(ahead, top / 1000.0), turn);
            }
            case P2osCommandNumber.SETRV -> {
                int top = Math.min(argument, P3dxScale.MOST_DEGREES_PER_SECOND);
                drive.setLimits(ahead, withTop(turn, Math.toRadians(top)));
            }
            default ->
                steering(number, argument).filter(steering -> control.take()).ifPresent(Runnable::run);
        }
    }

    private Optional<Runnable> steering(int number, int argument) {
        Runnable steering = switch (number) {
            case P2osCommandNumber.VEL -> () -> drive.setSpeed(argument / 1000.0);
            case P2osCommandNumber.ROTATE, P2osCommandNumber.RVEL -> () -> drive.setTurnSpeed(Math.toRadians(argument));
            case P2osCommandNumber.VEL2 -> () -> steerWheels((byte) (argument >> 8), (byte) argument);
            case P2osCommandNumber.MOVE -> () -> drive.move(argument / 1000.0);
            case P2osCommandNumber.HEAD -> () -> turnTo(Math.toRadians(argument));
            case P2osCommandNumber.DHEAD -> () -> drive.turn(Math.toRadians(argument));
            case P2osCommandNumber.DCHEAD -> () -> drive.turn(drive.remainingTurn() + Math.toRadians(argument));
            default -> null;
        };
        return Optional.ofNullable(steering);
    }

    private void turnTo(double headingRadians) {
        drive.turn(Math.IEEEremainder(headingRadians - robot.odometry().headingRadians(), 2 * Math.PI));
    }

    private void steerWheels(int left, int right) {
        double unit = P3dxScale.WHEEL_UNIT_MILLIMETERS_PER_SECOND / 1000;
        drive.setSpeed((left + right) * unit / 2);
        drive.setTurnSpeed((right - left) * unit / Pioneer2Dx.EFFECTIVE_TRACK_METERS);
    }

    /** The limits with another acceleration, or deceleration if the number is negative; 0 changes nothing. */
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
