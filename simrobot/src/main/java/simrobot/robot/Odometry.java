package simrobot.robot;

/**
 * The pose computed from the wheels' rotation, relative to that at the last reset. Dragging the robot, a belt under it
 * and a change of its true pose do not affect it.
 */
public final class Odometry {
    private double x;
    private double y;
    private double heading;
    private final Rotation direction = new Rotation();
    private final Arc arc = new Arc();
    private double left;
    private double right;

    Odometry() {}

    /** Adds an arc: the distance ahead and the turn. */
    void roll(double meters, double radians) {
        double chord = meters * arc.chordShare(radians);
        direction.to(heading + radians / 2);
        x += chord * direction.cos();
        y += chord * direction.sin();
        heading += radians;
        double half = radians * Pioneer2Dx.EFFECTIVE_TRACK_METERS / 2;
        left += meters - half;
        right += meters + half;
    }

    /** Sets position and heading; the wheels' distances are kept. */
    void set(double xMeters, double yMeters, double headingRadians) {
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

    /** Distance of the left wheel since the start, backward motion negative. */
    public double leftMeters() {
        return left;
    }

    /** Distance of the right wheel since the start, backward motion negative. */
    public double rightMeters() {
        return right;
    }
}
