package vericommand;

/**
 * Where a robot is, for the texts that tell it.
 *
 * @param headingDegrees 0 along +X, anticlockwise positive
 */
public record Pose(double xMeters, double yMeters, double headingDegrees) {
    public Pose {
        if (!Double.isFinite(xMeters) || !Double.isFinite(yMeters) || !Double.isFinite(headingDegrees)) {
            throw new IllegalArgumentException(
                    "a pose has finite numbers, not " + xMeters + " " + yMeters + " " + headingDegrees);
        }
    }
}
