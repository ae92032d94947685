package simrobot.world;

import java.util.List;
import java.util.stream.IntStream;

/**
 * A rectangle on the floor. The first four numbers are its corners before the rotation about the map's origin, as in
 * ARIA's maps.
 */
public record Area(double minXMeters, double minYMeters, double maxXMeters, double maxYMeters, double rotationRadians) {
    public Area {
        FiniteCheck.check("x1", minXMeters);
        FiniteCheck.check("y1", minYMeters);
        FiniteCheck.check("x2", maxXMeters);
        FiniteCheck.check("y2", maxYMeters);
        FiniteCheck.check("rotation", rotationRadians);
        if (minXMeters > maxXMeters || minYMeters > maxYMeters) {
            throw new IllegalArgumentException("an area's first corner lies beyond its second");
        }
    }

    /** The area between two opposite corners given in any order. */
    public static Area between(double x1, double y1, double x2, double y2, double rotationRadians) {
        return new Area(Math.min(x1, x2), Math.min(y1, y2), Math.max(x1, x2), Math.max(y1, y2), rotationRadians);
    }

    /** The upright area between two opposite corners. */
    static Area between(Position from, Position to) {
        return between(from.xMeters(), from.yMeters(), to.xMeters(), to.yMeters(), 0);
    }

    /** x1, y1, x2, y2 before the rotation. */
    double[] ends() {
        return new double[] {minXMeters, minYMeters, maxXMeters, maxYMeters};
    }

    public boolean contains(double xMeters, double yMeters) {
        double cos = Math.cos(rotationRadians);
        double sin = Math.sin(rotationRadians);
        double x = xMeters * cos + yMeters * sin;
        double y = yMeters * cos - xMeters * sin;
        return x >= minXMeters && x <= maxXMeters && y >= minYMeters && y <= maxYMeters;
    }

    /** The area shifted in the floor's directions even if it is turned. */
    public Area movedBy(double dxMeters, double dyMeters) {
        Position by = local(dxMeters, dyMeters);
        return new Area(
                Position.sum(minXMeters, by.xMeters()),
                Position.sum(minYMeters, by.yMeters()),
                Position.sum(maxXMeters, by.xMeters()),
                Position.sum(maxYMeters, by.yMeters()),
                rotationRadians);
    }

    /**
     * The area with one corner moved; the opposite corner is fixed.
     *
     * @param corner index in {@link #corners}
     */
    Area pulled(int corner, Position to) {
        Position there = local(to.xMeters(), to.yMeters());
        boolean left = corner == 0 || corner == 3;
        boolean low = corner <= 1;
        return between(
                there.xMeters(),
                there.yMeters(),
                left ? maxXMeters : minXMeters,
                low ? maxYMeters : minYMeters,
                rotationRadians);
    }

    /** A position in the area's frame, before the rotation. */
    public Position local(double xMeters, double yMeters) {
        if (rotationRadians == 0) {
            return new Position(xMeters, yMeters);
        }
        double cos = Math.cos(rotationRadians);
        double sin = Math.sin(rotationRadians);
        return new Position(xMeters * cos + yMeters * sin, yMeters * cos - xMeters * sin);
    }

    public Position center() {
        return turned(Position.sum(minXMeters, maxXMeters) / 2, Position.sum(minYMeters, maxYMeters) / 2);
    }

    /** The four corners, anticlockwise. */
    public List<Position> corners() {
        return List.of(
                turned(minXMeters, minYMeters),
                turned(maxXMeters, minYMeters),
                turned(maxXMeters, maxYMeters),
                turned(minXMeters, maxYMeters));
    }

    /** The four sides, anticlockwise. */
    public List<Segment> sides() {
        List<Position> corners = corners();
        return IntStream.range(0, 4)
                .mapToObj(i -> Segment.between(corners.get(i), corners.get((i + 1) % 4)))
                .toList();
    }

    private Position turned(double x, double y) {
        if (rotationRadians == 0) {
            return new Position(x, y);
        }
        double cos = Math.cos(rotationRadians);
        double sin = Math.sin(rotationRadians);
        return new Position(x * cos - y * sin, x * sin + y * cos);
    }
}
