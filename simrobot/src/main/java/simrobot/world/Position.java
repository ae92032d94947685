package simrobot.world;

/** A place on the floor, in metres. */
public record Position(double xMeters, double yMeters) {
    public Position {
        Finite.check("x", xMeters);
        Finite.check("y", yMeters);
    }
}
