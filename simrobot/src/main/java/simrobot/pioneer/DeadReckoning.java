package simrobot.pioneer;

import simrobot.p2os.InformationPacket;
import simrobot.robot.PoseRounding;
import vericommand.Pose;

/**
 * The pose of a robot by its own odometry, relative to the pose that was set last. Odometry counters wrap at 15 bits
 * (position) and a full turn (heading); of two possible differences the smaller is used.
 */
final class DeadReckoning {
    private static final int PLACE_BITS = 15;

    private double x;
    private double y;
    private double heading;

    /** Rotation from the odometry's frame to the world's, radians. */
    private double skew;

    private InformationPacket last;

    DeadReckoning(double xMeters, double yMeters, double headingRadians) {
        x = xMeters;
        y = yMeters;
        heading = headingRadians;
    }

    /** Begins a new session: the next packet is taken as the last pose. */
    void restart() {
        last = null;
    }

    /** Sets the true pose. */
    void setPose(double xMeters, double yMeters, double headingRadians) {
        x = xMeters;
        y = yMeters;
        skew += headingRadians - heading;
        heading = headingRadians;
    }

    void take(InformationPacket information, RobotKind kind) {
        if (last == null) {
            skew = heading - radians(information.heading(), kind);
        } else {
            int headingBits = Integer.numberOfTrailingZeros(kind.unitsPerTurn());
            double dx = step(information.x() - last.x(), PLACE_BITS) * kind.millimetersPerUnit() / 1000;
            double dy = step(information.y() - last.y(), PLACE_BITS) * kind.millimetersPerUnit() / 1000;
            x += dx * Math.cos(skew) - dy * Math.sin(skew);
            y += dx * Math.sin(skew) + dy * Math.cos(skew);
            heading += radians(step(information.heading() - last.heading(), headingBits), kind);
        }
        last = information;
    }

    /** Returns the smallest signed difference on a counter of {@code bits} bits. */
    private static int step(int difference, int bits) {
        int half = 1 << bits - 1;
        return (difference + half & (1 << bits) - 1) - half;
    }

    private static double radians(int units, RobotKind kind) {
        return units * 2 * Math.PI / kind.unitsPerTurn();
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
        return PoseRounding.pose(x, y, heading);
    }
}
