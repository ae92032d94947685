package simrobot.robot;

/**
 * The pose that follows from the wheels' rotation, relative to the pose at which it was last reset. Dragging the robot, a
 * belt under it and a change of its true pose do not change it.
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

    /** Adds an arc: a distance ahead, and the turn made meanwhile. */
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

    /** Sets place and heading; the wheels' distances go on. */
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

    /** Distance of the left wheel since the beginning, backward motion negative. */
    public double leftMeters() {
        return left;
    }

    /** Distance of the right wheel since the beginning, backward motion negative. */
    public double rightMeters() {
        return right;
    }
}
