package simrobot.robot;

/**
 * Where the wheels say that the robot is, from where it was last set to zero. Dragging the robot, a belt under it or a
 * client that moves its true pose leave it as it is.
 */
public final class Odometry {
    private double x;
    private double y;
    private double heading;
    private final Direction direction = new Direction();
    private double left;
    private double right;

    Odometry() {}

    /** The wheels roll along an arc: so far ahead while they turn the robot by so much. */
    void roll(double meters, double radians) {
        double chord = meters * Arc.chordShare(radians);
        direction.to(heading + radians / 2);
        x += chord * direction.cos();
        y += chord * direction.sin();
        heading += radians;
        double half = radians * Pioneer2Dx.EFFECTIVE_TRACK_METERS / 2;
        left += meters - half;
        right += meters + half;
    }

    /** From here on the place is 0, 0 and the heading 0; the wheels' ways go on. */
    public void reset() {
        x = 0;
        y = 0;
        heading = 0;
    }

    /** Takes what it said before; for a replay. */
    void restore(double xMeters, double yMeters, double headingRadians) {
        x = xMeters;
        y = yMeters;
        heading = headingRadians;
    }

    public double xMeters() {
        return x;
    }

    public double yMeters() {
        return y;
    }

    /** Anticlockwise, not wrapped. */
    public double headingRadians() {
        return heading;
    }

    /** All the way of the left wheel, back counted negative. */
    public double leftMeters() {
        return left;
    }

    /** All the way of the right wheel, back counted negative. */
    public double rightMeters() {
        return right;
    }
}
