package simrobot.behaviour;

/**
 * Commanded speeds of a robot.
 *
 * @param metersPerSecond ahead, negative back
 * @param radiansPerSecond anticlockwise
 */
public record Steering(double metersPerSecond, double radiansPerSecond) {
    public Steering {
        if (!Double.isFinite(metersPerSecond) || !Double.isFinite(radiansPerSecond)) {
            throw new IllegalArgumentException("a steering of " + metersPerSecond + " m/s and " + radiansPerSecond
                    + " rad/s, expected finite ones");
        }
    }
}
