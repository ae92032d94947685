package simrobot.robot;

import vericommand.Pose;

/** Poses without floating-point residue: rounded to 1 nm and 1e-9 degrees, headings in [0, 360). */
public final class PoseRounding {
    private PoseRounding() {}

    public static Pose pose(double xMeters, double yMeters, double headingRadians) {
        return new Pose(round(xMeters), round(yMeters), degrees(headingRadians));
    }

    private static double degrees(double radians) {
        double turned = Math.toDegrees(radians) % 360;
        double rounded = round(turned < 0 ? turned + 360 : turned);
        return rounded >= 360 ? 0 : rounded;
    }

    private static double round(double value) {
        return Math.rint(value * 1e9) / 1e9 + 0.0;
    }
}
