package simrobot.robot;

/** An angle with its cosine and sine, cached for the last angle. */
final class Rotation {
    private double radians;
    private double cos = 1;
    private double sin;

    Rotation to(double newRadians) {
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
