package simrobot.world;

import java.util.List;

/** A straight wall between two positions, in metres; both ends may be equal. */
public record Segment(double x1Meters, double y1Meters, double x2Meters, double y2Meters) implements WorldItem {
    public static final ItemKind<Segment> KIND = new ItemKind<>("wall", Segment.class)
            .printedAs("line")
            .corners(Segment::ends)
            .edited(
                    ItemKind.Shape.LINE,
                    values -> new Segment(
                            (Double) values.get("x1"), (Double) values.get("y1"), (Double) values.get("x2"), (Double)
                                    values.get("y2")),
                    (world, from, to) -> between(from, to));

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

    /** x1, y1, x2, y2. */
    public double[] ends() {
        return new double[] {x1Meters, y1Meters, x2Meters, y2Meters};
    }

    Position middle() {
        return new Position((x1Meters + x2Meters) / 2, (y1Meters + y2Meters) / 2);
    }

    @Override
    public ItemKind<Segment> kind() {
        return KIND;
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

    @Override
    public List<Segment> obstacles() {
        return List.of(this);
    }
}
