package simrobot.robot;

/** An angle with its cosine and sine, which are computed again only when the angle changes. */
final class Direction {
    private double radians;
    private double cos = 1;
    private double sin;

    Direction to(double newRadians) {
        if (newRadians != radians) {
            radians = newRadians;
            cos = StrictMath.cos(newRadians);
            sin = StrictMath.sin(newRadians);
        }
        return this;
    }

    double cos() {
        return cos;
    }

    double sin() {
        return sin;
    }
}
