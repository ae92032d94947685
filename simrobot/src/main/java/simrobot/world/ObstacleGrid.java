package simrobot.world;

import java.util.Arrays;
import java.util.List;

/**
 * A world's obstacles in a uniform grid, so that ranges, distances and contacts cost the same in small and in large
 * worlds. Immutable; readable on any thread.
 *
 * <p>Each cell lists the obstacles that touch it: {@code items[first[cell] .. first[cell + 1])}; an item below {@code
 * segmentCount} is a segment, the others are points.
 */
public final class ObstacleGrid {
    private static final double MAX_CELL_METERS = 2;
    private static final double MIN_CELL_METERS = 0.25;

    /** Maximum of cells; larger worlds get larger cells instead. */
    private static final int MAX_CELLS = 1 << 21;

    private final int segmentCount;
    private final int pointCount;

    /** x1, y1, x2, y2 of every segment. */
    private final double[] segments;

    /** x, y of every point. */
    private final double[] points;

    private final double pointRadius;
    private final double minX;
    private final double minY;
    private final double maxX;
    private final double maxY;
    private final double cell;
    private final int columns;
    private final int rows;
    private final int[] first;
    private final int[] items;

    public ObstacleGrid(World world) {
        List<Segment> walls = world.obstacles();
        segmentCount = walls.size();
        pointCount = world.items(Point.class).size();
        pointRadius = world.pointDiameterMeters() / 2;
        segments = new double[4 * segmentCount];
        points = new double[2 * pointCount];
        copy(walls, world.items(Point.class));
        BoundingBox around = new BoundingBox();
        walls.forEach(around::add);
        world.items(Point.class).forEach(around::add);
        Area bounds = around.or(new Area(0, 0, 0, 0, 0));
        double width = bounds.maxXMeters() - bounds.minXMeters();
        double height = bounds.maxYMeters() - bounds.minYMeters();
        cell = cellSize(width, height);
        // one cell more on each side, so that rounding at the border stays within the grid
        minX = bounds.minXMeters() - cell;
        minY = bounds.minYMeters() - cell;
        columns = (int) (width / cell) + 3;
        rows = (int) (height / cell) + 3;
        maxX = minX + columns * cell;
        maxY = minY + rows * cell;
        first = new int[columns * rows + 1];
        items = fill();
    }

    private void copy(List<Segment> walls, List<Point> dots) {
        for (int i = 0; i < segmentCount; i++) {
            Segment wall = walls.get(i);
            segments[4 * i] = wall.x1Meters();
            segments[4 * i + 1] = wall.y1Meters();
            segments[4 * i + 2] = wall.x2Meters();
            segments[4 * i + 3] = wall.y2Meters();
        }
        for (int i = 0; i < pointCount; i++) {
            points[2 * i] = dots.get(i).xMeters();
            points[2 * i + 1] = dots.get(i).yMeters();
        }
    }

    /** Side of a cell for about 4 obstacles where they are dense; 0.25 to 2 m. */
    private double cellSize(double width, double height) {
        double wanted = Math.sqrt(4 * (width + 1) * (height + 1) / (segmentCount + pointCount + 1.0));
        double size = Math.max(MIN_CELL_METERS, Math.min(MAX_CELL_METERS, wanted));
        while ((width / size + 3) * (height / size + 3) > MAX_CELLS) {
            size *= 2;
        }
        return size;
    }

    // ---- filling -------------------------------------------------------------------------------------------------

    /** Visits each cell that an obstacle touches. */
    private interface CellVisitor {
        void visit(int cellIndex, int item);
    }

    private int[] fill() {
        int[] counts = new int[columns * rows];
        eachCell((at, item) -> counts[at]++);
        for (int i = 0; i < counts.length; i++) {
            first[i + 1] = first[i] + counts[i];
        }
        int[] filled = new int[first[counts.length]];
        int[] next = first.clone();
        eachCell((at, item) -> filled[next[at]++] = item);
        return filled;
    }

    private void eachCell(CellVisitor visitor) {
        for (int i = 0; i < segmentCount; i++) {
            segmentCells(i, visitor);
        }
        for (int i = 0; i < pointCount; i++) {
            discCells(i, visitor);
        }
    }

    /** Visits row by row the columns that the wall crosses, with a tolerance of 1e-6 cells. */
    private void segmentCells(int i, CellVisitor visitor) {
        boolean upward = segments[4 * i + 1] <= segments[4 * i + 3];
        double xa = segments[4 * i + (upward ? 0 : 2)];
        double ya = segments[4 * i + (upward ? 1 : 3)];
        double xb = segments[4 * i + (upward ? 2 : 0)];
        double yb = segments[4 * i + (upward ? 3 : 1)];
        double tolerance = 1e-6 * cell;
        int last = row(yb + tolerance);
        for (int r = row(ya - tolerance); r <= last; r++) {
            double from = Math.max(ya, minY + r * cell - tolerance);
            double to = Math.min(yb, minY + (r + 1) * cell + tolerance);
            double x1 = yb > ya ? xa + (xb - xa) * clamp01((from - ya) / (yb - ya)) : xa;
            double x2 = yb > ya ? xa + (xb - xa) * clamp01((to - ya) / (yb - ya)) : xb;
            int right = column(Math.max(x1, x2) + tolerance);
            for (int c = column(Math.min(x1, x2) - tolerance); c <= right; c++) {
                visitor.visit(r * columns + c, i);
            }
        }
    }

    private static double clamp01(double value) {
        return Math.max(0, Math.min(1, value));
    }

    private void discCells(int i, CellVisitor visitor) {
        double reach = pointRadius + 1e-6 * cell;
        int top = row(points[2 * i + 1] + reach);
        int right = column(points[2 * i] + reach);
        for (int r = row(points[2 * i + 1] - reach); r <= top; r++) {
            for (int c = column(points[2 * i] - reach); c <= right; c++) {
                visitor.visit(r * columns + c, segmentCount + i);
            }
        }
    }

    private int column(double x) {
        return Math.max(0, Math.min(columns - 1, (int) Math.floor((x - minX) / cell)));
    }

    private int row(double y) {
        return Math.max(0, Math.min(rows - 1, (int) Math.floor((y - minY) / cell)));
    }

    // ---- queries --------------------------------------------------------------------------------------------------

    /** The first contact of a disc on a path by (dx, dy); metres. */
    public Contact sweep(double x, double y, double dx, double dy, double radiusMeters) {
        if (dx == 0 && dy == 0) {
            return Contact.NONE;
        }
        MovingDisc disc = new MovingDisc(x, y, dx, dy, radiusMeters);
        double rim = radiusMeters + 2 * MovingDisc.SKIN_METERS;
        int right = column(Math.max(x, x + dx) + rim);
        int top = row(Math.max(y, y + dy) + rim);
        for (int r = row(Math.min(y, y + dy) - rim); r <= top; r++) {
            for (int c = column(Math.min(x, x + dx) - rim); c <= right; c++) {
                addAll(disc, r * columns + c);
            }
        }
        return disc.contact();
    }

    private void addAll(MovingDisc disc, int at) {
        for (int k = first[at]; k < first[at + 1]; k++) {
            int i = items[k];
            if (i < segmentCount) {
                disc.addSegment(segments[4 * i], segments[4 * i + 1], segments[4 * i + 2], segments[4 * i + 3]);
            } else {
                int p = 2 * (i - segmentCount);
                disc.addPoint(points[p], points[p + 1]);
            }
        }
    }

    /** The distance to the nearest obstacle, at most {@code within}; metres. */
    public double clearance(double x, double y, double within) {
        double nearest = within;
        int right = column(x + within);
        int top = row(y + within);
        for (int r = row(y - within); r <= top; r++) {
            for (int c = column(x - within); c <= right; c++) {
                for (int k = first[r * columns + c]; k < first[r * columns + c + 1]; k++) {
                    nearest = Math.min(nearest, distance(items[k], x, y));
                }
            }
        }
        return nearest;
    }

    private double distance(int i, double x, double y) {
        if (i < segmentCount) {
            return Distances.toSegment(
                    x, y, segments[4 * i], segments[4 * i + 1], segments[4 * i + 2], segments[4 * i + 3]);
        }
        int p = 2 * (i - segmentCount);
        return Math.hypot(points[p] - x, points[p + 1] - y);
    }

    /** True if no obstacle is nearer than the radius. */
    public boolean isFree(double x, double y, double radiusMeters) {
        int left = column(x - radiusMeters);
        int right = column(x + radiusMeters);
        int top = row(y + radiusMeters);
        for (int r = row(y - radiusMeters); r <= top; r++) {
            for (int k = first[r * columns + left]; k < first[r * columns + right + 1]; k++) {
                if (distance(items[k], x, y) < radiusMeters) {
                    return false;
                }
            }
        }
        return true;
    }

    /** The obstacles within {@code reach} of a position; metres. */
    public NearbyObstacles near(double x, double y, double reach) {
        int left = column(x - reach);
        int right = column(x + reach);
        int low = row(y - reach);
        int top = row(y + reach);
        int most = 0;
        for (int r = low; r <= top; r++) {
            most += first[r * columns + right + 1] - first[r * columns + left];
        }
        // distance in the upper half, item in the lower one: sorted by distance, with duplicates adjacent
        long[] keys = new long[most];
        int count = 0;
        for (int r = low; r <= top; r++) {
            for (int k = first[r * columns + left]; k < first[r * columns + right + 1]; k++) {
                double distance = distance(items[k], x, y);
                if (distance <= reach) {
                    // the bits of non-negative floats have the order of their values
                    keys[count++] = (long) Float.floatToIntBits(below(distance)) << 32 | items[k];
                }
            }
        }
        Arrays.sort(keys, 0, count);
        return nearby(x, y, reach, keys, count);
    }

    private static float below(double distance) {
        return Math.max(0, Math.nextDown((float) distance));
    }

    private NearbyObstacles nearby(double x, double y, double reach, long[] keys, int count) {
        int[] nearItems = new int[count];
        float[] distances = new float[count];
        int size = 0;
        for (int i = 0; i < count; i++) {
            if (i == 0 || keys[i] != keys[i - 1]) {
                nearItems[size] = (int) keys[i];
                distances[size++] = Float.intBitsToFloat((int) (keys[i] >>> 32));
            }
        }
        return new NearbyObstacles(this, x, y, reach, Arrays.copyOf(nearItems, size), Arrays.copyOf(distances, size));
    }

    /** The distance to an item's part inside the cone; infinite when no part is. */
    double inCone(int i, Cone cone) {
        if (i < segmentCount) {
            return cone.distanceToSegment(
                    segments[4 * i], segments[4 * i + 1], segments[4 * i + 2], segments[4 * i + 3]);
        }
        int p = 2 * (i - segmentCount);
        return cone.distanceToPoint(points[p], points[p + 1]);
    }

    /**
     * The distance along a ray to the first obstacle, at most {@code maxMeters}. The ray is followed cell by cell
     * (Amanatides and Woo 1987) up to the cell of its hit.
     *
     * @param ux with uy the ray's direction, a unit vector
     */
    public double rayRange(double x, double y, double ux, double uy, double maxMeters) {
        double enter = entry(x, y, ux, uy, maxMeters);
        if (enter >= maxMeters) {
            return maxMeters;
        }
        int c = column(x + ux * enter);
        int r = row(y + uy * enter);
        int stepX = ux < 0 ? -1 : 1;
        int stepRow = uy < 0 ? -columns : columns;
        double perX = 1 / ux;
        double perY = 1 / uy;
        double deltaX = cell * Math.abs(perX);
        double deltaY = cell * Math.abs(perY);
        double nextX = ux == 0 ? Double.POSITIVE_INFINITY : (minX + (c + (ux > 0 ? 1 : 0)) * cell - x) * perX;
        double nextY = uy == 0 ? Double.POSITIVE_INFINITY : (minY + (r + (uy > 0 ? 1 : 0)) * cell - y) * perY;
        int at = r * columns + c;
        int cellsX = ux < 0 ? c : columns - 1 - c;
        int cellsY = uy < 0 ? r : rows - 1 - r;
        double nearest = maxMeters;
        while (true) {
            int end = first[at + 1];
            for (int k = first[at]; k < end; k++) {
                double hit = hit(items[k], x, y, ux, uy);
                nearest = hit < nearest ? hit : nearest;
            }
            if (nextX < nextY) {
                if (nearest <= nextX || --cellsX < 0) {
                    return nearest;
                }
                at += stepX;
                nextX += deltaX;
            } else {
                if (nearest <= nextY || --cellsY < 0) {
                    return nearest;
                }
                at += stepRow;
                nextY += deltaY;
            }
        }
    }

    /** The distance at which a ray enters the grid, 0 from inside; {@code max} if it does not. */
    private double entry(double x, double y, double ux, double uy, double max) {
        if (x >= minX && y >= minY && x < maxX && y < maxY) {
            return 0;
        }
        double in = 0;
        double out = max;
        if (ux != 0) {
            double low = (minX - x) / ux;
            double high = (maxX - x) / ux;
            in = Math.max(in, Math.min(low, high));
            out = Math.min(out, Math.max(low, high));
        } else if (x < minX || x > maxX) {
            return max;
        }
        if (uy != 0) {
            double low = (minY - y) / uy;
            double high = (maxY - y) / uy;
            in = Math.max(in, Math.min(low, high));
            out = Math.min(out, Math.max(low, high));
        } else if (y < minY || y > maxY) {
            return max;
        }
        return in <= out ? in : max;
    }

    private double hit(int i, double x, double y, double ux, double uy) {
        if (i < segmentCount) {
            return Distances.alongRay(
                    x, y, ux, uy, segments[4 * i], segments[4 * i + 1], segments[4 * i + 2], segments[4 * i + 3]);
        }
        int p = 2 * (i - segmentCount);
        return Distances.alongRayToDisc(x, y, ux, uy, points[p], points[p + 1], pointRadius);
    }
}
