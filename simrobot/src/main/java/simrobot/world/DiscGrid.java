package simrobot.world;

import java.util.Arrays;

/**
 * A spatial index of moving discs; the cost of a query does not grow with the number of discs.
 *
 * <p>The floor is wrapped on a torus of square cells, so memory is proportional to the number of discs and not to the floor.
 * A cell lists the discs whose centres are in it or in a distant cell that wraps onto it; each is tested exactly. The owner
 * numbers the discs from 0. For one thread.
 */
public final class DiscGrid {
    private static final double CELL_METERS = 4;
    private static final int LEAST_SIDE = 8;
    private static final int NONE = -1;

    private int side = LEAST_SIDE;
    private int count;

    /** The first disc of each cell's list. */
    private int[] heads = emptyCells(LEAST_SIDE);

    private int[] next = {};
    private int[] previous = {};

    /** The cell of each disc's centre; valid if {@link #isIn}. */
    private int[] columns = {};

    private int[] rows = {};
    private boolean[] isIn = {};
    private double[] xs = {};
    private double[] ys = {};
    private int[] found = {};

    private static int[] emptyCells(int side) {
        int[] cells = new int[side * side];
        Arrays.fill(cells, NONE);
        return cells;
    }

    private static int line(double meters) {
        return (int) Math.floor(meters / CELL_METERS);
    }

    private int cell(int column, int row) {
        return (row & side - 1) * side + (column & side - 1);
    }

    // ---- moving --------------------------------------------------------------------------------------------------

    /** Adds a disc, or moves it. */
    public void put(int disc, double x, double y) {
        reserve(disc);
        int column = line(x);
        int row = line(y);
        boolean stays = isIn[disc] && columns[disc] == column && rows[disc] == row;
        if (!stays) {
            remove(disc);
            count++;
            growTorus();
            columns[disc] = column;
            rows[disc] = row;
            link(disc);
        }
        xs[disc] = x;
        ys[disc] = y;
    }

    /** Removes a disc, if it is there. */
    public void remove(int disc) {
        if (disc < isIn.length && isIn[disc]) {
            unlink(disc);
            count--;
        }
    }

    private void reserve(int disc) {
        if (disc >= xs.length) {
            int room = Math.max(2 * xs.length, disc + 1);
            xs = Arrays.copyOf(xs, room);
            ys = Arrays.copyOf(ys, room);
            columns = Arrays.copyOf(columns, room);
            rows = Arrays.copyOf(rows, room);
            isIn = Arrays.copyOf(isIn, room);
            found = Arrays.copyOf(found, room);
            next = Arrays.copyOf(next, room);
            previous = Arrays.copyOf(previous, room);
        }
    }

    /** Keeps at least as many cells as discs. */
    private void growTorus() {
        if (count > side * side) {
            side *= 2;
            heads = emptyCells(side);
            for (int disc = 0; disc < xs.length; disc++) {
                if (isIn[disc]) {
                    link(disc);
                }
            }
        }
    }

    private void link(int disc) {
        int cell = cell(columns[disc], rows[disc]);
        int head = heads[cell];
        previous[disc] = NONE;
        next[disc] = head;
        if (head != NONE) {
            previous[head] = disc;
        }
        heads[cell] = disc;
        isIn[disc] = true;
    }

    private void unlink(int disc) {
        if (previous[disc] == NONE) {
            heads[cell(columns[disc], rows[disc])] = next[disc];
        } else {
            next[previous[disc]] = next[disc];
        }
        if (next[disc] != NONE) {
            previous[next[disc]] = previous[disc];
        }
        isIn[disc] = false;
    }

    // ---- queries --------------------------------------------------------------------------------------------------

    /**
     * Finds the discs whose centres are in an upright rectangle, each once, in no particular order; {@link #found} returns
     * them until the next query.
     *
     * @return their number
     */
    public int near(double minX, double minY, double maxX, double maxY) {
        int left = line(minX);
        int low = line(minY);
        // a rectangle larger than the torus visits each cell once
        int right = Math.min(line(maxX), left + side - 1);
        int high = Math.min(line(maxY), low + side - 1);
        int size = 0;
        for (int row = low; row <= high; row++) {
            for (int column = left; column <= right; column++) {
                for (int disc = heads[cell(column, row)]; disc != NONE; disc = next[disc]) {
                    if (xs[disc] >= minX && xs[disc] <= maxX && ys[disc] >= minY && ys[disc] <= maxY) {
                        found[size++] = disc;
                    }
                }
            }
        }
        return size;
    }

    /**
     * The distance from a position to the nearest centre of a disc other than {@code except}, at most {@code within}.
     */
    public double clearance(int except, double x, double y, double within) {
        double square = within * within;
        for (int i = near(x - within, y - within, x + within, y + within) - 1; i >= 0; i--) {
            double dx = xs[found[i]] - x;
            double dy = ys[found[i]] - y;
            if (found[i] != except) {
                square = Math.min(square, dx * dx + dy * dy);
            }
        }
        return Math.sqrt(square);
    }

    /** A disc that was found. @param i from 0 */
    public int found(int i) {
        return found[i];
    }

    /** True if the centre of a disc other than {@code except} is nearer to the position than {@code within}. */
    public boolean isCrowded(int except, double x, double y, double within) {
        for (int i = near(x - within, y - within, x + within, y + within) - 1; i >= 0; i--) {
            double dx = xs[found[i]] - x;
            double dy = ys[found[i]] - y;
            if (dx * dx + dy * dy < within * within && found[i] != except) {
                return true;
            }
        }
        return false;
    }
}
