package simrobot.world;

/** A position on the floor, in metres. */
public record Position(double xMeters, double yMeters) {
    public Position {
        FiniteCheck.check("x", xMeters);
        FiniteCheck.check("y", yMeters);
    }

    /** The position shifted, and rounded to 1 nm against floating-point error if it changes. */
    public Position movedBy(double dxMeters, double dyMeters) {
        return new Position(sum(xMeters, dxMeters), sum(yMeters, dyMeters));
    }

    static double sum(double meters, double more) {
        return more == 0 ? meters : Math.rint((meters + more) * 1e9) / 1e9;
    }
}
