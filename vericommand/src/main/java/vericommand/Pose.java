package vericommand;

import java.util.Locale;

/**
 * A robot's position and headingfor texts.
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

    /** Metres with this number of decimals, after a dot in every language. */
    public String xText(int decimals) {
        return decimal(xMeters, decimals);
    }

    public String yText(int decimals) {
        return decimal(yMeters, decimals);
    }

    /** Degrees in [0, 360); a value that would round to 360 is 0. */
    public String headingText(int decimals) {
        double scale = Math.pow(10, decimals);
        double rounded = Math.round(headingDegrees * scale) / scale % 360;
        return decimal(rounded < 0 ? rounded + 360 : rounded, decimals);
    }

    /** A value that rounds to zero has no sign. */
    private static String decimal(double value, int decimals) {
        double scale = Math.pow(10, decimals);
        return String.format(Locale.ROOT, "%." + decimals + "f", Math.round(value * scale) / scale);
    }
}
