package simrobot.pioneer;

import simrobot.p2os.InformationPacket;
import simrobot.robot.PoseRounding;
import vericommand.Pose;

/**
 * The pose of a robot by its odometry, relative to the last set pose. Odometry counters wrap at 15 bits (position) and
 * a full turn (heading); of two possible differences the smaller is used. Impossibly long steps, as after a reset, are
 * ignored.
 */
final class DeadReckoning {
    private static final int PLACE_BITS = 15;

    /** Above the speed of any robot's wheels: packets of up to 0.15 s may arrive together after a delay. */
    private static final double MOST_METERS_PER_SECOND = 2;

    private static final double MOST_RADIANS_PER_SECOND = Math.toRadians(500);
    private static final double LEAST_SECONDS = 0.15;

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

    /** Begins a session: the next packet corresponds to the last pose. */
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

    /** @param passedNanos since the last packet */
    void take(InformationPacket information, RobotKind kind, long passedNanos) {
        if (last == null || !follow(information, kind, Math.max(LEAST_SECONDS, passedNanos / 1e9))) {
            skew = heading - radians(information.heading(), kind);
        }
        last = information;
    }

    /** @return false, with nothing changed, if no robot moves so far within the seconds */
    private boolean follow(InformationPacket information, RobotKind kind, double seconds) {
        int headingBits = Integer.numberOfTrailingZeros(kind.unitsPerTurn());
        double dx = step(information.x() - last.x(), PLACE_BITS) * kind.millimetersPerUnit() / 1000;
        double dy = step(information.y() - last.y(), PLACE_BITS) * kind.millimetersPerUnit() / 1000;
        double turned = radians(step(information.heading() - last.heading(), headingBits), kind);
        boolean isPossible = Math.hypot(dx, dy) <= MOST_METERS_PER_SECOND * seconds
                && Math.abs(turned) <= MOST_RADIANS_PER_SECOND * seconds;
        if (isPossible) {
            x += dx * Math.cos(skew) - dy * Math.sin(skew);
            y += dx * Math.sin(skew) + dy * Math.cos(skew);
            heading += turned;
        }
        return isPossible;
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
