package simrobot.world;

import java.util.Arrays;

/**
 * Discs of one size that move about, found by where they are; asking costs the same among ten and among ten thousand.
 *
 * <p>The floor is wrapped on a torus of square cells, so memory goes by the number of discs and not by the floor's size.
 * A cell lists the discs whose middles are in it, and also those in cells far away that are wrapped upon it: each is tested
 * exactly, so that costs a little time and changes no answer. Discs have numbers from 0 that their owner gives. One thread
 * owns it.
 */
public final class DiscGrid {
    private static final double CELL_METERS = 4;
    private static final int LEAST_SIDE = 8;
    private static final int NONE = -1;

    private int side = LEAST_SIDE;
    private int count;

    /** The first disc of each cell. */
    private int[] heads = emptyCells(LEAST_SIDE);

    private int[] next = {};
    private int[] previous = {};

    /** Where each disc's middle is, in cells; {@link #isIn} says whether it is anywhere. */
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

    /** Puts a disc there, whether it was somewhere before or not. */
    public void put(int disc, double x, double y) {
        makeRoom(disc);
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

    /** Takes a disc away; one that is not there stays so. */
    public void remove(int disc) {
        if (disc < isIn.length && isIn[disc]) {
            unlink(disc);
            count--;
        }
    }

    private void makeRoom(int disc) {
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

    /** More cells than discs. */
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

    // ---- asking --------------------------------------------------------------------------------------------------

    /**
     * Finds the discs whose middles are in an upright rectangle, each once, in no order that means anything;
     * {@link #found} names them until the next question.
     *
     * @return how many
     */
    public int near(double minX, double minY, double maxX, double maxY) {
        int left = line(minX);
        int low = line(minY);
        // whoever asks for more than there is sees each cell once
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

    /** One of the discs that were found, from 0. */
    public int found(int i) {
        return found[i];
    }

    /** Whether the middle of a disc, other than that one's, is nearer to the place than so much. */
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
