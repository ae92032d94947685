package simrobot.robot;

import vericommand.Pose;

/** Poses for people: rounding dust below a nanometre and a nanodegree is wiped off, headings are in [0, 360). */
final class PoseRounding {
    private PoseRounding() {}

    static Pose pose(double xMeters, double yMeters, double headingRadians) {
        return new Pose(clean(xMeters), clean(yMeters), degrees(headingRadians));
    }

    private static double degrees(double radians) {
        double turned = Math.toDegrees(radians) % 360;
        double rounded = clean(turned < 0 ? turned + 360 : turned);
        return rounded >= 360 ? 0 : rounded;
    }

    private static double clean(double value) {
        return Math.rint(value * 1e9) / 1e9 + 0.0;
    }
}
