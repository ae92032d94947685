package simrobot.robot;

/** Arcs of circles, which a robot runs along while it goes and turns at once. */
final class Arc {
    /** Within so much turning a chord lies at most 0.05 mm beside its arc, at the robot's top speed in a step. */
    private static final double CHORD_RADIANS = 0.015;

    private Arc() {}

    /** The chord's length over the arc's, 1 for a straight way. */
    static double chordShare(double radians) {
        double half = radians / 2;
        return Math.abs(half) < 1e-6 ? 1 : StrictMath.sin(half) / half;
    }

    /** In how many chords an arc is gone along. */
    static int chords(double meters, double radians) {
        return meters == 0 ? 1 : Math.max(1, (int) Math.ceil(Math.abs(radians) / CHORD_RADIANS));
    }
}
