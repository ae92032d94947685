package simrobot.source;

import simrobot.behaviour.Call;
import simrobot.behaviour.OdometryPose;
import simrobot.behaviour.Senses;

/** A robot's senses during one decision, read when they are asked for. Ranges have millimetres, as those that children read. */
final class DirectSenses implements Senses {
    /** Null after the decision: the robot has moved. */
    private Senses live;

    DirectSenses(Senses live) {
        this.live = live;
    }

    void close() {
        live = null;
    }

    private Senses live() {
        if (live == null) {
            throw new IllegalStateException("senses of an earlier decision: keep their numbers, not the Senses");
        }
        return live;
    }

    private static double millimeters(double meters) {
        return Math.round(meters * 1000) / 1000.0;
    }

    @Override
    public double sonarMeters(int sonar) {
        return millimeters(live().sonarMeters(sonar));
    }

    @Override
    public double laserMeters(int reading) {
        return millimeters(live().laserMeters(reading));
    }

    @Override
    public double xMeters() {
        return live().xMeters();
    }

    @Override
    public double yMeters() {
        return live().yMeters();
    }

    @Override
    public double headingRadians() {
        return live().headingRadians();
    }

    @Override
    public OdometryPose odometry() {
        return live().odometry();
    }

    @Override
    public double metersPerSecond() {
        return live().metersPerSecond();
    }

    @Override
    public boolean isBlocked() {
        return live().isBlocked();
    }

    @Override
    public boolean isFrontBumperPressed(int bumper) {
        return live().isFrontBumperPressed(bumper);
    }

    @Override
    public boolean isRearBumperPressed(int bumper) {
        return live().isRearBumperPressed(bumper);
    }

    @Override
    public double seconds() {
        return live().seconds();
    }

    @Override
    public boolean hasArrived() {
        return live().hasArrived();
    }

    @Override
    public Call call() {
        return live().call();
    }
}
