package simrobot.behaviour;

/**
 * Commanded speeds of a robot. The robot reaches them with its acceleration; it drives at most 1 m/s and turns at most 150
 * degrees per second.
 *
 * @param metersPerSecond ahead, negative back
 * @param radiansPerSecond anticlockwise
 */
public record Steering(double metersPerSecond, double radiansPerSecond) {
    /** Both speeds 0. */
    public static final Steering STOP = new Steering(0, 0);

    /** @throws IllegalArgumentException if a speed is infinite or not a number */
    public Steering {
        if (!Double.isFinite(metersPerSecond) || !Double.isFinite(radiansPerSecond)) {
            throw new IllegalArgumentException("a steering of " + metersPerSecond + " m/s and " + radiansPerSecond
                    + " rad/s, expected finite ones");
        }
    }

    /**
     * Creates speeds with the turn in degrees.
     *
     * @param degreesPerSecond anticlockwise: positive turns to the left
     */
    public static Steering ofDegrees(double metersPerSecond, double degreesPerSecond) {
        return new Steering(metersPerSecond, Math.toRadians(degreesPerSecond));
    }
}
