package simrobot.pioneer;

import simrobot.robot.Bumpers;
import simrobot.robot.ProcessSenses;
import vericommand.RobotStatus;

/** The senses of a real robot, by its newest information packet; its pose is that of the odometry. It has no laser here. */
final class RealSenses extends ProcessSenses {
    private final RealPioneer robot;

    RealSenses(RealPioneer robot) {
        this.robot = robot;
    }

    @Override
    public double sonarMeters(int sonar) {
        return robot.sonarMeters(sonar);
    }

    @Override
    public double laserMeters(int reading) {
        throw new UnsupportedOperationException("a real robot has no laser here, expected sonarMeters");
    }

    @Override
    public double xMeters() {
        return robot.pose().xMeters();
    }

    @Override
    public double yMeters() {
        return robot.pose().yMeters();
    }

    @Override
    public double headingRadians() {
        return robot.headingRadians();
    }

    @Override
    public double metersPerSecond() {
        return robot.metersPerSecond();
    }

    @Override
    protected RobotStatus status() {
        return robot.status();
    }

    @Override
    protected Bumpers bumpers() {
        return robot.bumpers();
    }
}
