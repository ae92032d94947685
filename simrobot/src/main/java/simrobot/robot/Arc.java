package simrobot.robot;

/** Geometry of the circular arc on which a robot moves while it drives and turns at once. */
final class Arc {
    /** At the robot's top speed in a step, a chord over this angle deviates from its arc by at most 0.05 mm. */
    private static final double CHORD_RADIANS = 0.015;

    private Arc() {}

    /** The chord's length divided by the arc's; 1 for a straight line. */
    static double chordShare(double radians) {
        double half = radians / 2;
        return Math.abs(half) < 1e-6 ? 1 : StrictMath.sin(half) / half;
    }

    /** The number of chords that replace an arc. */
    static int chords(double meters, double radians) {
        return meters == 0 ? 1 : Math.max(1, (int) Math.ceil(Math.abs(radians) / CHORD_RADIANS));
    }
}
