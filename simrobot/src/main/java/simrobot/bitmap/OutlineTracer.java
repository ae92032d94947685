package simrobot.bitmap;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/**
 * Traces the outlines of occupied cells: closed lines along the cells' edges, simplified so that no corner of an outline is
 * farther than one cell from the traced line. Coordinates are cells, from the lower left corner of the grid.
 */
final class OutlineTracer {
    /** Right, up, left, down: the occupied cell is at the left of an edge. */
    private static final int[] DX = {1, 0, -1, 0};

    private static final int[] DY = {0, 1, 0, -1};
    private static final double TOLERANCE_CELLS = 1;

    private final int width;
    private final int height;
    private final BitSet occupied;
    /** The outgoing edges of each corner of a cell, a bit for each direction. */
    private final byte[] edges;

    /** @param occupied cell (column, row) at row times width plus column, rows from the bottom */
    OutlineTracer(int width, int height, BitSet occupied) {
        this.width = width;
        this.height = height;
        this.occupied = occupied;
        edges = new byte[(width + 1) * (height + 1)];
        for (int cell = occupied.nextSetBit(0); cell >= 0; cell = occupied.nextSetBit(cell + 1)) {
            int x = cell % width;
            int y = cell / width;
            edge(x, y - 1, x, y, 0);
            edge(x + 1, y, x + 1, y, 1);
            edge(x, y + 1, x + 1, y + 1, 2);
            edge(x - 1, y, x, y + 1, 3);
        }
    }

    private void edge(int neighbourX, int neighbourY, int x, int y, int direction) {
        boolean inside = neighbourX >= 0 && neighbourY >= 0 && neighbourX < width && neighbourY < height;
        if (!inside || !occupied.get(neighbourY * width + neighbourX)) {
            edges[y * (width + 1) + x] |= (byte) (1 << direction);
        }
    }

    /** All outlines; each is a closed line of at least two corners, x and y alternating. */
    List<int[]> outlines() {
        List<int[]> outlines = new ArrayList<>();
        for (int corner = 0; corner < edges.length; corner++) {
            while (edges[corner] != 0) {
                outlines.add(simplified(trace(corner)));
            }
        }
        return outlines;
    }

    /** The corners at which an outline turns. It joins two cells that share only a corner. */
    private int[] trace(int start) {
        List<Integer> corners = new ArrayList<>();
        int corner = start;
        int direction = Integer.numberOfTrailingZeros(edges[corner]);
        do {
            edges[corner] &= (byte) ~(1 << direction);
            corner += DX[direction] + DY[direction] * (width + 1);
            int next = next(corner, direction);
            if (next != direction) {
                corners.add(corner);
            }
            direction = next;
        } while (direction >= 0);
        int[] xy = new int[2 * corners.size()];
        for (int i = 0; i < corners.size(); i++) {
            xy[2 * i] = corners.get(i) % (width + 1);
            xy[2 * i + 1] = corners.get(i) / (width + 1);
        }
        return xy;
    }

    /** Right, straight ahead, left; -1 at the end of the outline. */
    private int next(int corner, int direction) {
        for (int turn = 3; turn <= 5; turn++) {
            int next = (direction + turn) % 4;
            if ((edges[corner] >> next & 1) != 0) {
                return next;
            }
        }
        return -1;
    }

    // ---- simplification (Douglas and Peucker, 1973)
    // ------------------------------------------------------------------

    private static int[] simplified(int[] xy) {
        int count = xy.length / 2;
        if (count <= 4) {
            return xy;
        }
        int far = 0;
        for (int i = 1; i < count; i++) {
            far = square(xy, 0, i) > square(xy, 0, far) ? i : far;
        }
        BitSet kept = new BitSet(count);
        kept.set(0);
        kept.set(far);
        List<int[]> open = new ArrayList<>(List.of(new int[] {0, far}, new int[] {far, count}));
        while (!open.isEmpty()) {
            int[] part = open.remove(open.size() - 1);
            int worst = worst(xy, part[0], part[1]);
            if (worst >= 0) {
                kept.set(worst);
                open.add(new int[] {part[0], worst});
                open.add(new int[] {worst, part[1]});
            }
        }
        int[] result = new int[2 * kept.cardinality()];
        int at = 0;
        for (int i = kept.nextSetBit(0); i >= 0; i = kept.nextSetBit(i + 1)) {
            result[at++] = xy[2 * i];
            result[at++] = xy[2 * i + 1];
        }
        return result;
    }

    private static double square(int[] xy, int i, int j) {
        double dx = xy[2 * i] - xy[2 * j];
        double dy = xy[2 * i + 1] - xy[2 * j + 1];
        return dx * dx + dy * dy;
    }

    /** The corner between two others that is farthest from their line, if it is too far; else -1. */
    private static int worst(int[] xy, int from, int to) {
        int end = to % (xy.length / 2);
        double x = xy[2 * from];
        double y = xy[2 * from + 1];
        double dx = xy[2 * end] - x;
        double dy = xy[2 * end + 1] - y;
        double length = Math.hypot(dx, dy);
        int worst = -1;
        double most = TOLERANCE_CELLS;
        for (int i = from + 1; i < to; i++) {
            double px = xy[2 * i] - x;
            double py = xy[2 * i + 1] - y;
            double away = length == 0 ? Math.hypot(px, py) : Math.abs(px * dy - py * dx) / length;
            if (away > most) {
                most = away;
                worst = i;
            }
        }
        return worst;
    }
}
