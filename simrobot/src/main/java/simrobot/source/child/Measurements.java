package simrobot.source.child;

import java.util.function.IntToDoubleFunction;
import simrobot.behaviour.Call;
import simrobot.behaviour.OdometryPose;
import simrobot.behaviour.Senses;

/**
 * Senses at one moment.
 *
 * @param front bumpers, a 1 for each that is pressed, else a 0
 * @param sonars ranges by number, in metres
 */
public record Measurements(
        double seconds,
        double xMeters,
        double yMeters,
        double headingRadians,
        OdometryPose odometry,
        double metersPerSecond,
        boolean isBlocked,
        boolean hasArrived,
        Call call,
        String front,
        String rear,
        IntToDoubleFunction sonars,
        IntToDoubleFunction laser)
        implements Senses {
    @Override
    public double sonarMeters(int sonar) {
        return sonars.applyAsDouble(sonar);
    }

    @Override
    public double laserMeters(int reading) {
        return laser.applyAsDouble(reading);
    }

    @Override
    public boolean isFrontBumperPressed(int bumper) {
        return front.charAt(bumper) == '1';
    }

    @Override
    public boolean isRearBumperPressed(int bumper) {
        return rear.charAt(bumper) == '1';
    }
}
