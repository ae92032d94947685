package simrobot.robot;

import simrobot.behaviour.Senses;
import vericommand.RobotStatus;

/** The senses of a process, measured when they are asked for, and the time since it began. */
final class ProcessSenses implements Senses {
    private final Pioneer robot;
    private long nanos;

    ProcessSenses(Pioneer robot) {
        this.robot = robot;
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
