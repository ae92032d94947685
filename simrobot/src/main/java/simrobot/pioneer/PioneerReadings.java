package simrobot.pioneer;

import java.util.Arrays;
import java.util.Optional;
import simrobot.p2os.InformationPacket;
import simrobot.robot.Battery;
import simrobot.robot.Bumpers;
import simrobot.robot.Condition;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SonarRing;
import simrobot.robot.Trail;
import simrobot.simulation.RobotSnapshot;
import vericommand.Pose;

/** The newest information packet of a real robot, and its pose, path and sonar ranges by all packets so far. */
final class PioneerReadings {
    private final DeadReckoning place;
    private final Trail trail;
    private final double[] sonarsMeters = new double[SonarRing.COUNT];
    private Optional<InformationPacket> newest = Optional.empty();
    private double wheelSpeedFactor;
    private long measuredNanos;

    /** @param trail the robot's path, extended by each packet */
    PioneerReadings(Pose start, Trail trail) {
        this.trail = trail;
        place = new DeadReckoning(start.xMeters(), start.yMeters(), Math.toRadians(start.headingDegrees()));
        restart();
    }

    /** Begins a session: the sonars have no ranges yet, and odometry continues from the newest pose. */
    void restart() {
        place.restart();
        Arrays.fill(sonarsMeters, Pioneer2Dx.SONAR_RANGE_METERS);
    }

    /** The connection is lost. */
    void lose() {
        newest = Optional.empty();
    }

    /**
     * Takes a packet.
     *
     * @param kind its units; without them only its flags are used
     * @return the time since the last packet, 0 after the first
     */
    long take(InformationPacket information, Optional<RobotKind> kind, long nanos) {
        long passedNanos = newest.isEmpty() ? 0 : nanos - measuredNanos;
        newest = Optional.of(information);
        measuredNanos = nanos;
        wheelSpeedFactor = kind.map(RobotKind::wheelSpeedFactor).orElse(0.0) / 1000;
        kind.ifPresent(units -> measure(information, units, passedNanos));
        return passedNanos;
    }

    private void measure(InformationPacket information, RobotKind kind, long passedNanos) {
        place.take(information, kind, passedNanos);
        trail.pass(place.xMeters(), place.yMeters(), measuredNanos);
        for (InformationPacket.Echo echo : information.echoes()) {
            if (echo.sonar() < sonarsMeters.length) {
                double meters = Math.round(echo.range() * kind.millimetersPerRangeUnit()) / 1000.0;
                sonarsMeters[echo.sonar()] =
                        Math.max(Pioneer2Dx.SONAR_LEAST_METERS, Math.min(Pioneer2Dx.SONAR_RANGE_METERS, meters));
            }
        }
    }

    /** Sets the pose after the robot was moved by hand. */
    void setPose(double xMeters, double yMeters, double headingRadians) {
        place.setPose(xMeters, yMeters, headingRadians);
        trail.clear();
    }

    DeadReckoning place() {
        return place;
    }

    /** The newest packet; empty without a connection. */
    Optional<InformationPacket> newest() {
        return newest;
    }

    /** The time of the newest packet. */
    long measuredNanos() {
        return measuredNanos;
    }

    double leftMetersPerSecond() {
        return newest.map(InformationPacket::leftWheel).orElse(0) * wheelSpeedFactor;
    }

    double rightMetersPerSecond() {
        return newest.map(InformationPacket::rightWheel).orElse(0) * wheelSpeedFactor;
    }

    private double volts() {
        return newest.map(InformationPacket::batteryDecivolts).orElse(0) / 10.0;
    }

    boolean hasLowBattery() {
        return newest.isPresent() && volts() < Battery.LOW_VOLTS;
    }

    Bumpers bumpers() {
        return newest.map(packet -> new Bumpers(packet.frontBumpers(), packet.rearBumpers()))
                .orElse(new Bumpers(0, 0));
    }

    double sonarMeters(int sonar) {
        return sonarsMeters[sonar];
    }

    RobotSnapshot snapshot(RealPioneer robot) {
        boolean stalled = newest.map(InformationPacket::stalled).orElse(false);
        return new RobotSnapshot(
                robot.name(),
                robot.status(),
                robot.isPowered(),
                robot.hasMotors(),
                place.xMeters(),
                place.yMeters(),
                place.headingRadians(),
                robot.speedMetersPerSecond(),
                (rightMetersPerSecond() - leftMetersPerSecond()) / Pioneer2Dx.EFFECTIVE_TRACK_METERS,
                sonarsMeters.clone(),
                new double[0],
                new Condition(volts(), hasLowBattery(), stalled, bumpers(), robot.pose(), new Pose(0, 0, 0)),
                trail.points(),
                robot.autonomy().kind(),
                robot.autonomy().path(),
                robot.autonomy().marks(),
                false);
    }
}
