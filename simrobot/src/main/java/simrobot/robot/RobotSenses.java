package simrobot.robot;

import vericommand.RobotStatus;

/** The senses of a simulated robot, measured when they are asked for. */
final class RobotSenses extends ProcessSenses {
    private final SimulatedRobot robot;

    RobotSenses(SimulatedRobot robot) {
        this.robot = robot;
    }

    @Override
    public double sonarMeters(int sonar) {
        return robot.sonarRangeMeters(sonar);
    }

    @Override
    public double laserMeters(int reading) {
        return robot.laserRangeMeters(reading);
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
    protected RobotStatus status() {
        return robot.status();
    }

    @Override
    protected Bumpers bumpers() {
        return robot.bumpers();
    }
}
