package simrobot.robot;

/** Headings for people: degrees in [0, 360). */
final class Degrees {
    private Degrees() {}

    static double of(double radians) {
        double turned = Math.toDegrees(radians) % 360;
        double rounded = Math.rint((turned < 0 ? turned + 360 : turned) * 1e9) / 1e9;
        return rounded >= 360 ? 0 : rounded + 0.0;
    }
}
