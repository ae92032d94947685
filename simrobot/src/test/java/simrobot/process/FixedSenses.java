package simrobot.process;

import java.util.Arrays;
import simrobot.behaviour.Call;
import simrobot.behaviour.OdometryPose;
import simrobot.behaviour.Senses;

/** Senses of a robot at the origin that hears nothing but what a test sets. */
public final class FixedSenses implements Senses {
    private final double[] sonars = new double[SONARS];
    private boolean blocked;

    public FixedSenses() {
        Arrays.fill(sonars, 5);
    }

    public FixedSenses sonar(int sonar, double meters) {
        sonars[sonar] = meters;
        return this;
    }

    public FixedSenses blocked() {
        blocked = true;
        return this;
    }

    @Override
    public double sonarMeters(int sonar) {
        return sonars[sonar];
    }

    @Override
    public double laserMeters(int reading) {
        return 32;
    }

    @Override
    public double xMeters() {
        return 0;
    }

    @Override
    public double yMeters() {
        return 0;
    }

    @Override
    public double headingRadians() {
        return 0;
    }

    @Override
    public double metersPerSecond() {
        return 0;
    }

    @Override
    public boolean isBlocked() {
        return blocked;
    }

    @Override
    public boolean isFrontBumperPressed(int bumper) {
        return blocked;
    }

    @Override
    public boolean isRearBumperPressed(int bumper) {
        return false;
    }

    @Override
    public double seconds() {
        return 0;
    }

    @Override
    public OdometryPose odometry() {
        return new OdometryPose(0, 0, 0);
    }

    @Override
    public boolean hasArrived() {
        return false;
    }

    @Override
    public Call call() {
        return new Call("", NO_KEY, "");
    }
}
