package simrobot.world;

import java.util.Arrays;

/**
 * Discs of one size that move about, found by where they are; asking costs the same among ten and among ten thousand.
 *
 * <p>The floor is wrapped on a torus of square cells, so memory goes by the number of discs and not by the floor's size.
 * A cell lists the discs that reach into it, and also those that reach into a cell far away which is wrapped upon it: who
 * asks tests each of them exactly, so that costs a little time and changes no answer. Discs have numbers from 0 that
 * their owner gives. One thread owns it.
 */
public final class DiscGrid {
    private static final double CELL_METERS = 1;

    /** A disc is smaller than a cell, so it reaches into four at most. */
    private static final int CELLS_OF_A_DISC = 4;

    private static final int LEAST_SIDE = 16;
    private static final int CELLS_PER_DISC = 4;
    private static final int NONE = -1;

    private final double reach;
    private int side = LEAST_SIDE;
    private int count;

    /** The first node of each cell. A node is disc * 4 + k. */
    private int[] heads = emptyCells(LEAST_SIDE);

    private int[] next = {};
    private int[] previous = {};

    /** The cell of each node; none for a node that is not used. */
    private int[] cells = {};

    /** Lowest and highest column and row that each disc reaches into. */
    private int[] spans = {};

    private double[] xs = {};
    private double[] ys = {};
    private int[] seen = {};
    private int[] found = {};
    private int question;

    /** @param reachMeters no part of a disc, or of what it stands for, is farther from its middle; at most half a cell */
    public DiscGrid(double reachMeters) {
        if (!(reachMeters > 0 && reachMeters <= CELL_METERS / 2)) {
            throw new IllegalArgumentException(
                    "a reach of " + reachMeters + " m, expected above 0 and at most " + CELL_METERS / 2);
        }
        reach = reachMeters;
    }

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

    /** Puts a disc there, whether it was somewhere before or not. */
    public void put(int disc, double x, double y) {
        makeRoom(disc);
        xs[disc] = x;
        ys[disc] = y;
        int left = line(x - reach);
        int right = line(x + reach);
        int low = line(y - reach);
        int high = line(y + reach);
        int at = CELLS_OF_A_DISC * disc;
        boolean present = cells[at] != NONE;
        if (present && spans[at] == left && spans[at + 1] == right && spans[at + 2] == low && spans[at + 3] == high) {
            return;
        }
        if (present) {
            unlinkAll(disc);
        } else {
            count++;
            growTorus();
        }
        spans[at] = left;
        spans[at + 1] = right;
        spans[at + 2] = low;
        spans[at + 3] = high;
        linkAll(disc);
    }

    /** Takes a disc away; one that is not there stays so. */
    public void remove(int disc) {
        if (disc < xs.length && cells[CELLS_OF_A_DISC * disc] != NONE) {
            unlinkAll(disc);
            count--;
        }
    }

    private void makeRoom(int disc) {
        if (disc >= xs.length) {
            int room = Math.max(2 * xs.length, disc + 1);
            int before = cells.length;
            xs = Arrays.copyOf(xs, room);
            ys = Arrays.copyOf(ys, room);
            seen = Arrays.copyOf(seen, room);
            found = Arrays.copyOf(found, room);
            next = Arrays.copyOf(next, CELLS_OF_A_DISC * room);
            previous = Arrays.copyOf(previous, CELLS_OF_A_DISC * room);
            cells = Arrays.copyOf(cells, CELLS_OF_A_DISC * room);
            spans = Arrays.copyOf(spans, CELLS_OF_A_DISC * room);
            Arrays.fill(cells, before, cells.length, NONE);
        }
    }

    private void growTorus() {
        if (CELLS_PER_DISC * count <= side * side) {
            return;
        }
        side *= 2;
        heads = emptyCells(side);
        for (int disc = 0; disc < xs.length; disc++) {
            if (cells[CELLS_OF_A_DISC * disc] != NONE) {
                Arrays.fill(cells, CELLS_OF_A_DISC * disc, CELLS_OF_A_DISC * (disc + 1), NONE);
                linkAll(disc);
            }
        }
    }

    private void linkAll(int disc) {
        int node = CELLS_OF_A_DISC * disc;
        int at = node;
        for (int row = spans[at + 2]; row <= spans[at + 3]; row++) {
            for (int column = spans[at]; column <= spans[at + 1]; column++) {
                link(node++, cell(column, row));
            }
        }
    }

    private void link(int node, int cell) {
        int head = heads[cell];
        cells[node] = cell;
        previous[node] = NONE;
        next[node] = head;
        if (head != NONE) {
            previous[head] = node;
        }
        heads[cell] = node;
    }

    private void unlinkAll(int disc) {
        for (int node = CELLS_OF_A_DISC * disc; node < CELLS_OF_A_DISC * (disc + 1); node++) {
            if (cells[node] != NONE) {
                unlink(node);
            }
        }
    }

    private void unlink(int node) {
        if (previous[node] == NONE) {
            heads[cells[node]] = next[node];
        } else {
            next[previous[node]] = next[node];
        }
        if (next[node] != NONE) {
            previous[next[node]] = previous[node];
        }
        cells[node] = NONE;
    }

    // ---- asking --------------------------------------------------------------------------------------------------

    /**
     * Finds the discs that may reach into an upright rectangle, each once, in no order; {@link #found} names them until
     * the next question.
     *
     * @return how many
     */
    public int near(double minX, double minY, double maxX, double maxY) {
        int left = line(minX);
        int low = line(minY);
        int columns = Math.min(line(maxX) - left, side - 1);
        int rows = Math.min(line(maxY) - low, side - 1);
        question++;
        int size = 0;
        for (int row = low; row <= low + rows; row++) {
            for (int column = left; column <= left + columns; column++) {
                for (int node = heads[cell(column, row)]; node != NONE; node = next[node]) {
                    int disc = node / CELLS_OF_A_DISC;
                    if (seen[disc] != question) {
                        seen[disc] = question;
                        found[size++] = disc;
                    }
                }
            }
        }
        return size;
    }

    /** One of the discs that were found, from 0. */
    public int found(int i) {
        return found[i];
    }

    /** Whether a disc's middle, other than that one's, is nearer to the place than so much; at most the reach twice. */
    public boolean isCrowded(int except, double x, double y, double within) {
        double beyond = within - reach;
        int right = line(x + beyond);
        int high = line(y + beyond);
        for (int row = line(y - beyond); row <= high; row++) {
            for (int column = line(x - beyond); column <= right; column++) {
                for (int node = heads[cell(column, row)]; node != NONE; node = next[node]) {
                    int disc = node / CELLS_OF_A_DISC;
                    double dx = xs[disc] - x;
                    double dy = ys[disc] - y;
                    if (dx * dx + dy * dy < within * within && disc != except) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /**
     * The distance along a single ray to the first disc other than that one, or {@code max}; the ray walks the cells.
     *
     * @param ux with uy the ray's direction, a unit vector
     */
    public double rayRange(int except, double x, double y, double ux, double uy, double radius, double max) {
        int column = line(x);
        int row = line(y);
        int stepX = ux < 0 ? -1 : 1;
        int stepY = uy < 0 ? -1 : 1;
        double deltaX = CELL_METERS / Math.abs(ux);
        double deltaY = CELL_METERS / Math.abs(uy);
        double nextX = ux == 0 ? Double.POSITIVE_INFINITY : ((column + (ux > 0 ? 1 : 0)) * CELL_METERS - x) / ux;
        double nextY = uy == 0 ? Double.POSITIVE_INFINITY : ((row + (uy > 0 ? 1 : 0)) * CELL_METERS - y) / uy;
        double nearest = max;
        while (true) {
            for (int node = heads[cell(column, row)]; node != NONE; node = next[node]) {
                int disc = node / CELLS_OF_A_DISC;
                if (disc != except) {
                    nearest = Math.min(nearest, Distances.alongRayToDisc(x, y, ux, uy, xs[disc], ys[disc], radius));
                }
            }
            double leave = Math.min(nextX, nextY);
            if (nearest <= leave) {
                return nearest;
            }
            if (nextX < nextY) {
                column += stepX;
                nextX += deltaX;
            } else {
                row += stepY;
                nextY += deltaY;
            }
        }
    }
}
