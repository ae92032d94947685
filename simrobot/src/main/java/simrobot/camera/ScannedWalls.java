package simrobot.camera;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import simrobot.world.Position;

/**
 * Joins points that lie close together, as a laser has scanned them along a wall, to pieces of that wall. The light on a
 * piece comes from the direction of all points around it, so that the scanner's noise does not look like corrugated iron.
 */
final class ScannedWalls {
    /** The numbers of a piece: its ends x1, y1, x2, y2, and the wall's direction there as a unit vector. */
    static final int NUMBERS = 6;

    /** Neighbouring points of one wall; scans have one every 2 to 5 cm. */
    private static final double JOINED_METERS = 0.12;

    /** The points around that give a wall its direction. */
    private static final double AROUND_METERS = 0.3;

    private final Map<Long, List<Position>> cells = new HashMap<>();
    private final List<double[]> joined = new ArrayList<>();
    private final List<double[]> alone = new ArrayList<>();

    ScannedWalls(List<Position> points) {
        points.forEach(point -> cells.computeIfAbsent(cell(point, 0, 0), key -> new ArrayList<>())
                .add(point));
        points.forEach(this::join);
    }

    double[] pieces() {
        return flat(joined);
    }

    /** The points that are joined to none, x and y of each. */
    double[] single() {
        return flat(alone);
    }

    private static double[] flat(List<double[]> rows) {
        return rows.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    private static long cell(Position point, int right, int up) {
        long column = (long) Math.floor(point.xMeters() / AROUND_METERS) + right;
        long row = (long) Math.floor(point.yMeters() / AROUND_METERS) + up;
        return column << 32 ^ row & 0xFFFF_FFFFL;
    }

    /** Joins a point to its nearest neighbour on either side along the wall. */
    private void join(Position point) {
        List<Position> around = around(point);
        double direction = direction(around);
        double ux = Math.cos(direction);
        double uy = Math.sin(direction);
        Position before = nearest(point, around, -ux, -uy);
        Position after = nearest(point, around, ux, uy);
        if (before == null && after == null) {
            alone.add(new double[] {point.xMeters(), point.yMeters()});
        }
        if (before != null) {
            add(before, point, ux, uy);
        }
        if (after != null) {
            add(point, after, ux, uy);
        }
    }

    private void add(Position from, Position to, double ux, double uy) {
        joined.add(new double[] {from.xMeters(), from.yMeters(), to.xMeters(), to.yMeters(), ux, uy});
    }

    private List<Position> around(Position point) {
        List<Position> around = new ArrayList<>();
        for (int right = -1; right <= 1; right++) {
            for (int up = -1; up <= 1; up++) {
                for (Position other : cells.getOrDefault(cell(point, right, up), List.of())) {
                    if (distance(point, other) < AROUND_METERS) {
                        around.add(other);
                    }
                }
            }
        }
        return around;
    }

    private static double distance(Position a, Position b) {
        return Math.hypot(a.xMeters() - b.xMeters(), a.yMeters() - b.yMeters());
    }

    /** The axis of the points' largest spread, radians. */
    private static double direction(List<Position> around) {
        double meanX = around.stream().mapToDouble(Position::xMeters).average().orElse(0);
        double meanY = around.stream().mapToDouble(Position::yMeters).average().orElse(0);
        double xx = 0;
        double xy = 0;
        double yy = 0;
        for (Position other : around) {
            double dx = other.xMeters() - meanX;
            double dy = other.yMeters() - meanY;
            xx += dx * dx;
            xy += dx * dy;
            yy += dy * dy;
        }
        return Math.atan2(2 * xy, xx - yy) / 2;
    }

    /** The nearest point on one side; null if there is none to join. */
    private static Position nearest(Position point, List<Position> around, double ux, double uy) {
        Position nearest = null;
        double least = JOINED_METERS;
        for (Position other : around) {
            double along = (other.xMeters() - point.xMeters()) * ux + (other.yMeters() - point.yMeters()) * uy;
            double meters = distance(point, other);
            if (along > meters / 2 && meters < least) {
                least = meters;
                nearest = other;
            }
        }
        return nearest;
    }
}
