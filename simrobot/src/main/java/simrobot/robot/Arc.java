package simrobot.robot;

/** Geometry of the circular arc of a robot that drives and turns at once. */
final class Arc {
    /** At the robot's top speed in a step, a chord over this angle deviates from its arc by at most 0.05 mm. */
    private static final double CHORD_RADIANS = 0.015;

    private double radians;
    private double share = 1;

    /** The chord's length divided by the arc's; 1 for a straight line. Cached for the last angle. */
    double chordShare(double turnRadians) {
        if (turnRadians != radians) {
            radians = turnRadians;
            double half = turnRadians / 2;
            share = Math.abs(half) < 1e-6 ? 1 : StrictMath.sin(half) / half;
        }
        return share;
    }

    /** The number of chords that replace an arc. */
    static int chords(double meters, double radians) {
        return meters == 0 ? 1 : Math.max(1, (int) Math.ceil(Math.abs(radians) / CHORD_RADIANS));
    }
}
