package simrobot.world;

import java.util.List;

/** A straight wall between two places, in metres; both ends may be the same place. */
public record Segment(double x1Meters, double y1Meters, double x2Meters, double y2Meters) implements WorldItem {
    public Segment {
        FiniteCheck.check("x1", x1Meters);
        FiniteCheck.check("y1", y1Meters);
        FiniteCheck.check("x2", x2Meters);
        FiniteCheck.check("y2", y2Meters);
    }

    /** A wall from one place to another. */
    public static Segment between(Position from, Position to) {
        return new Segment(from.xMeters(), from.yMeters(), to.xMeters(), to.yMeters());
    }

    @Override
    public Segment movedBy(double dxMeters, double dyMeters) {
        return between(
                handles().get(0).movedBy(dxMeters, dyMeters), handles().get(1).movedBy(dxMeters, dyMeters));
    }

    @Override
    public List<Position> handles() {
        return List.of(new Position(x1Meters, y1Meters), new Position(x2Meters, y2Meters));
    }

    @Override
    public Segment pulled(int handle, Position to) {
        return handle == 0 ? between(to, handles().get(1)) : between(handles().get(0), to);
    }
}
