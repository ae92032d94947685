package simrobot.world;

import java.util.List;

/** A small round obstacle of the world's point diameter, such as a reading of a laser scan; it stops robots and sonar. */
public record Point(double xMeters, double yMeters) implements WorldItem {
    public static final ItemKind<Point> KIND = new ItemKind<>("point", Point.class)
            .number("x", ItemField.Unit.METERS, Point::xMeters)
            .number("y", ItemField.Unit.METERS, Point::yMeters);

    public Point {
        FiniteCheck.check("x", xMeters);
        FiniteCheck.check("y", yMeters);
    }

    @Override
    public ItemKind<Point> kind() {
        return KIND;
    }

    private Position place() {
        return new Position(xMeters, yMeters);
    }

    @Override
    public Point movedBy(double dxMeters, double dyMeters) {
        return pulled(0, place().movedBy(dxMeters, dyMeters));
    }

    @Override
    public List<Position> handles() {
        return List.of(place());
    }

    @Override
    public Point pulled(int handle, Position to) {
        return new Point(to.xMeters(), to.yMeters());
    }
}
