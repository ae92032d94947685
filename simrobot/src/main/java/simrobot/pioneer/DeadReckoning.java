package simrobot.pioneer;

import simrobot.p2os.InformationPacket;
import vericommand.Pose;

/**
 * Where a robot is, by its own odometry from where it was last said to stand. The odometry rolls over at 15 bits and 4096
 * units; steps are taken the short way round.
 */
final class DeadReckoning {
    private static final int PLACE_BITS = 15;
    private static final double DUST = 1e9;

    private double x;
    private double y;
    private double heading;

    /** From the odometry's axes to the world's. */
    private double skew;

    private InformationPacket last;

    DeadReckoning(double xMeters, double yMeters, double headingRadians) {
        x = xMeters;
        y = yMeters;
        heading = headingRadians;
    }

    /** The next information is the first of a new session: its place is where the robot was last. */
    void restart() {
        last = null;
    }

    /** Somebody says where the robot stands. */
    void setPose(double xMeters, double yMeters, double headingRadians) {
        x = xMeters;
        y = yMeters;
        skew += headingRadians - heading;
        heading = headingRadians;
    }

    void take(InformationPacket information, RobotScale scale) {
        if (last == null) {
            skew = heading - radians(information.heading());
        } else {
            double dx = step(information.x() - last.x(), PLACE_BITS) * scale.millimetersPerUnit() / 1000;
            double dy = step(information.y() - last.y(), PLACE_BITS) * scale.millimetersPerUnit() / 1000;
            x += dx * Math.cos(skew) - dy * Math.sin(skew);
            y += dx * Math.sin(skew) + dy * Math.cos(skew);
            heading += radians(step(information.heading() - last.heading(), 12));
        }
        last = information;
    }

    /** The short way round a counter of so many bits. */
    private static int step(int difference, int bits) {
        int half = 1 << bits - 1;
        return (difference + half & (1 << bits) - 1) - half;
    }

    private static double radians(int units) {
        return units * 2 * Math.PI / RobotScale.UNITS_PER_TURN;
    }

    double xMeters() {
        return x;
    }

    double yMeters() {
        return y;
    }

    /** Anticlockwise, not wrapped. */
    double headingRadians() {
        return heading;
    }

    Pose pose() {
        double degrees = Math.toDegrees(heading) % 360;
        double rounded = clean(degrees < 0 ? degrees + 360 : degrees);
        return new Pose(clean(x), clean(y), rounded >= 360 ? 0 : rounded);
    }

    private static double clean(double value) {
        return Math.rint(value * DUST) / DUST + 0.0;
    }
}
