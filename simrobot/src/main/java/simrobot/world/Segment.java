package simrobot.world;

/** A straight wall between two places, in metres; both ends may be the same place. */
public record Segment(double x1Meters, double y1Meters, double x2Meters, double y2Meters) {
    public Segment {
        Finite.check("x1", x1Meters);
        Finite.check("y1", y1Meters);
        Finite.check("x2", x2Meters);
        Finite.check("y2", y2Meters);
    }
}
