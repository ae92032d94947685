package simrobot.robot;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import simrobot.behaviour.Requests;
import simrobot.behaviour.Senses;
import simrobot.process.CallKeys;
import vericommand.Pose;
import vericommand.RobotStatus;

/** The senses of a process, measured when they are asked for, and the time since it began. */
final class ProcessSenses implements Senses {
    private final Pioneer robot;
    private final Supplier<String> caller;
    private final CallKeys call;
    private final BooleanSupplier arrived;
    private final Pose start;
    private final Pose odometryStart;
    private final double turn;
    private long nanos;

    /** @param arrived whether the robot has come to the place that the process asked for */
    ProcessSenses(Pioneer robot, Supplier<String> caller, CallKeys call, BooleanSupplier arrived) {
        this.robot = robot;
        this.caller = caller;
        this.call = call;
        this.arrived = arrived;
        start = robot.pose();
        odometryStart = robot.odometryPose();
        turn = Math.toRadians(start.headingDegrees() - odometryStart.headingDegrees());
    }

    void elapse(long passedNanos) {
        nanos += passedNanos;
    }

    @Override
    public double seconds() {
        return nanos * 1e-9;
    }

    @Override
    public double sonarMeters(int sonar) {
        return robot.sonarMeters(sonar);
    }

    @Override
    public double laserMeters(int reading) {
        return robot.laserMeters(reading);
    }

    @Override
    public double xMeters() {
        return robot.xMeters();
    }

    @Override
    public double yMeters() {
        return robot.yMeters();
    }

    @Override
    public double headingRadians() {
        return Math.atan2(Math.sin(robot.headingRadians()), Math.cos(robot.headingRadians()));
    }

    @Override
    public double odometryXMeters() {
        Pose now = robot.odometryPose();
        return start.xMeters()
                + (now.xMeters() - odometryStart.xMeters()) * Math.cos(turn)
                - (now.yMeters() - odometryStart.yMeters()) * Math.sin(turn);
    }

    @Override
    public double odometryYMeters() {
        Pose now = robot.odometryPose();
        return start.yMeters()
                + (now.xMeters() - odometryStart.xMeters()) * Math.sin(turn)
                + (now.yMeters() - odometryStart.yMeters()) * Math.cos(turn);
    }

    @Override
    public double odometryHeadingRadians() {
        double heading = Math.toRadians(robot.odometryPose().headingDegrees()) + turn;
        return Math.atan2(Math.sin(heading), Math.cos(heading));
    }

    @Override
    public boolean hasArrived() {
        return arrived.getAsBoolean();
    }

    @Override
    public char key() {
        Requests.noteKeys();
        return call.key();
    }

    /** Each key once: reading them hands them over. */
    @Override
    public String pressedKeys() {
        Requests.noteKeys();
        return call.takePressed();
    }

    @Override
    public String caller() {
        return caller.get();
    }

    @Override
    public double metersPerSecond() {
        return robot.speedMetersPerSecond();
    }

    @Override
    public boolean isBlocked() {
        return robot.status() == RobotStatus.COLLISION;
    }

    @Override
    public boolean isFrontBumperPressed(int bumper) {
        return isPressed(robot.bumpers().front(), bumper);
    }

    @Override
    public boolean isRearBumperPressed(int bumper) {
        return isPressed(robot.bumpers().rear(), bumper);
    }

    private static boolean isPressed(int bits, int bumper) {
        if (bumper < 0 || bumper >= Bumpers.COUNT_EACH) {
            throw new IndexOutOfBoundsException("bumper " + bumper + ", expected 0 to " + (Bumpers.COUNT_EACH - 1));
        }
        return (bits >> bumper & 1) != 0;
    }
}
