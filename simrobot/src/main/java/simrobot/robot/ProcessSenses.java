package simrobot.robot;

import simrobot.behaviour.Call;
import simrobot.behaviour.OdometryPose;
import simrobot.behaviour.Senses;
import vericommand.Pose;
import vericommand.RobotStatus;

/** The senses of a process, measured when read, and the time since its beginning. */
final class ProcessSenses implements Senses {
    private final Pioneer robot;
    private final Pose start;
    private final Pose odometryStart;
    private long nanos;
    private Call heard;

    ProcessSenses(Pioneer robot) {
        this.robot = robot;
        start = robot.pose();
        odometryStart = robot.odometryPose();
    }

    void elapse(long passedNanos) {
        nanos += passedNanos;
        heard = null;
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
        return wrapped(robot.headingRadians());
    }

    private static double wrapped(double radians) {
        return Math.atan2(Math.sin(radians), Math.cos(radians));
    }

    @Override
    public OdometryPose odometry() {
        Pose now = robot.odometryPose();
        double dx = now.xMeters() - odometryStart.xMeters();
        double dy = now.yMeters() - odometryStart.yMeters();
        double turn = Math.toRadians(start.headingDegrees() - odometryStart.headingDegrees());
        return new OdometryPose(
                start.xMeters() + dx * Math.cos(turn) - dy * Math.sin(turn),
                start.yMeters() + dx * Math.sin(turn) + dy * Math.cos(turn),
                wrapped(Math.toRadians(now.headingDegrees()) + turn));
    }

    @Override
    public boolean hasArrived() {
        return robot.autonomy().hasArrived();
    }

    /** The call; its keys are consumed by the first read in a decision. */
    @Override
    public Call call() {
        heard = heard == null ? robot.autonomy().call().take() : heard;
        return heard;
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
