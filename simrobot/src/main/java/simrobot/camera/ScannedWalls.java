package simrobot.camera;

import java.util.Arrays;
import java.util.List;
import simrobot.world.Point;

/**
 * Joins close points, as scanned by a laser along a wall, to pieces of that wall. The light on a piece depends on the
 * direction of all points around it, so that the scanner's noise does not look like corrugated iron.
 */
final class ScannedWalls {
    /** The numbers of a piece: its ends x1, y1, x2, y2, and the wall's direction there as a unit vector. */
    static final int NUMBERS = 6;

    /** Maximum distance of neighbours in a wall; scans have a point every 2 to 5 cm. */
    private static final double JOINED_METERS = 0.12;

    /** Radius around a point that determines the wall's direction. */
    private static final double AROUND_METERS = 0.25;

    private static final int MOST_CELLS = 1_000_000;
    private static final int NONE = -1;

    private final double[] xs;
    private final double[] ys;

    // a grid of square cells, each with a list of the points in it
    private final double left;
    private final double bottom;
    private final double cellMeters;
    private final int columns;
    private final int[] heads;
    private final int[] nexts;

    /** The two neighbours of each point. */
    private final int[] partners;

    private double[] pieces = new double[64];
    private int pieceNumbers;
    private double[] single = new double[64];
    private int singleNumbers;

    // direction at the current point
    private double ux;
    private double uy;

    ScannedWalls(List<Point> points) {
        xs = points.stream().mapToDouble(Point::xMeters).toArray();
        ys = points.stream().mapToDouble(Point::yMeters).toArray();
        left = Arrays.stream(xs).min().orElse(0);
        bottom = Arrays.stream(ys).min().orElse(0);
        double wide = Arrays.stream(xs).max().orElse(0) - left;
        double high = Arrays.stream(ys).max().orElse(0) - bottom;
        double least = Math.max(wide, high) / Math.sqrt(MOST_CELLS);
        cellMeters = Math.max(AROUND_METERS, least);
        columns = (int) (wide / cellMeters) + 3;
        heads = new int[columns * ((int) (high / cellMeters) + 3)];
        nexts = new int[xs.length];
        partners = new int[2 * xs.length];
        Arrays.fill(heads, NONE);
        for (int i = 0; i < xs.length; i++) {
            int cell = cell(i);
            nexts[i] = heads[cell];
            heads[cell] = i;
        }
        for (int i = 0; i < xs.length; i++) {
            join(i);
        }
    }

    double[] pieces() {
        return Arrays.copyOf(pieces, pieceNumbers);
    }

    /** The isolated points, x and y of each. */
    double[] single() {
        return Arrays.copyOf(single, singleNumbers);
    }

    /** The grid has an extra cell on each side. */
    private int cell(int i) {
        int column = 1 + (int) ((xs[i] - left) / cellMeters);
        int row = 1 + (int) ((ys[i] - bottom) / cellMeters);
        return row * columns + column;
    }

    /** Joins a point to its nearest neighbour on either side along the wall. */
    private void join(int i) {
        findDirection(i);
        int before = nearest(i, -1);
        int after = nearest(i, 1);
        partners[2 * i] = before;
        partners[2 * i + 1] = after;
        if (before == NONE && after == NONE) {
            single = Arrays.copyOf(single, singleNumbers == single.length ? 2 * singleNumbers : single.length);
            single[singleNumbers++] = xs[i];
            single[singleNumbers++] = ys[i];
        }
        add(i, before);
        add(i, after);
    }

    /** Adds a piece, unless the other point has added it. */
    private void add(int i, int other) {
        if (other == NONE || (other < i && (partners[2 * other] == i || partners[2 * other + 1] == i))) {
            return;
        }
        if (pieceNumbers + NUMBERS > pieces.length) {
            pieces = Arrays.copyOf(pieces, 2 * pieces.length);
        }
        for (double number : new double[] {xs[i], ys[i], xs[other], ys[other], ux, uy}) {
            pieces[pieceNumbers++] = number;
        }
    }

    /** The axis of the largest spread of the points around. */
    private void findDirection(int i) {
        double n = 0;
        double sumX = 0;
        double sumY = 0;
        double xx = 0;
        double xy = 0;
        double yy = 0;
        int middle = cell(i);
        for (int at = 0; at < 9; at++) {
            for (int j = heads[middle + (at / 3 - 1) * columns + at % 3 - 1]; j != NONE; j = nexts[j]) {
                double dx = xs[j] - xs[i];
                double dy = ys[j] - ys[i];
                if (dx * dx + dy * dy < AROUND_METERS * AROUND_METERS) {
                    n++;
                    sumX += dx;
                    sumY += dy;
                    xx += dx * dx;
                    xy += dx * dy;
                    yy += dy * dy;
                }
            }
        }
        double direction = Math.atan2(2 * (xy - sumX * sumY / n), xx - sumX * sumX / n - yy + sumY * sumY / n) / 2;
        ux = Math.cos(direction);
        uy = Math.sin(direction);
    }

    /**
     * The nearest point on one side.
     *
     * @param side 1 along the direction, -1 against it
     */
    private int nearest(int i, int side) {
        int nearest = NONE;
        double least = JOINED_METERS * JOINED_METERS;
        int middle = cell(i);
        for (int at = 0; at < 9; at++) {
            for (int j = heads[middle + (at / 3 - 1) * columns + at % 3 - 1]; j != NONE; j = nexts[j]) {
                double dx = xs[j] - xs[i];
                double dy = ys[j] - ys[i];
                double square = dx * dx + dy * dy;
                double along = side * (dx * ux + dy * uy);
                if (square < least && along > 0 && along * along > square / 4) {
                    least = square;
                    nearest = j;
                }
            }
        }
        return nearest;
    }
}
