package simrobot.route;

import java.util.Arrays;
import simrobot.world.Area;
import simrobot.world.ForbiddenArea;
import simrobot.world.ForbiddenLine;
import simrobot.world.Point;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

/**
 * The distance from each cell of a world's floor to the nearest wall, point, box, forbidden line or forbidden area;
 * immutable. Cells are 5 cm wide, wider in a world of more than 10 000 square metres, so that there are at most 4 million.
 */
public final class ClearanceGrid {
    private static final double LEAST_CELL_METERS = 0.05;
    private static final double MOST_CELLS = 4e6;
    private static final float FAR = 1e12f;

    private final double left;
    private final double bottom;
    private final double cellMeters;
    private final int width;
    private final int height;
    /** Metres, row by row from the bottom. */
    private final float[] clearance;

    public ClearanceGrid(World world) {
        Area ground = world.ground();
        double wide = ground.maxXMeters() - ground.minXMeters();
        double high = ground.maxYMeters() - ground.minYMeters();
        cellMeters = Math.max(LEAST_CELL_METERS, Math.sqrt(wide * high / MOST_CELLS));
        left = ground.minXMeters();
        bottom = ground.minYMeters();
        width = (int) Math.ceil(wide / cellMeters) + 1;
        height = (int) Math.ceil(high / cellMeters) + 1;
        clearance = new float[width * height];
        Arrays.fill(clearance, FAR);
        world.obstacles().forEach(this::mark);
        world.items(ForbiddenLine.class).forEach(forbidden -> mark(forbidden.line()));
        world.items(Point.class).forEach(point -> mark(point.xMeters(), point.yMeters()));
        world.items(ForbiddenArea.class).forEach(forbidden -> mark(forbidden.area()));
        transform();
    }

    private void mark(double x, double y) {
        int cell = cell(x, y);
        if (cell >= 0) {
            clearance[cell] = 0;
        }
    }

    private void mark(Segment line) {
        double dx = line.x2Meters() - line.x1Meters();
        double dy = line.y2Meters() - line.y1Meters();
        int steps = 1 + (int) (2 * Math.hypot(dx, dy) / cellMeters);
        for (int i = 0; i <= steps; i++) {
            mark(line.x1Meters() + dx * i / steps, line.y1Meters() + dy * i / steps);
        }
    }

    private void mark(Area area) {
        area.sides().forEach(this::mark);
        for (int cell = 0; cell < clearance.length; cell++) {
            if (area.contains(xMeters(cell), yMeters(cell))) {
                clearance[cell] = 0;
            }
        }
    }

    // ---- exact squared distances, by columns and then by rows (Felzenszwalb and Huttenlocher, 2012)
    // -------------------

    private void transform() {
        int longest = Math.max(width, height);
        float[] line = new float[longest];
        float[] result = new float[longest];
        int[] parabolas = new int[longest];
        float[] borders = new float[longest + 1];
        for (int x = 0; x < width; x++) {
            for (int y = 0; y < height; y++) {
                line[y] = clearance[y * width + x];
            }
            transform(line, height, result, parabolas, borders);
            for (int y = 0; y < height; y++) {
                clearance[y * width + x] = result[y];
            }
        }
        for (int y = 0; y < height; y++) {
            System.arraycopy(clearance, y * width, line, 0, width);
            transform(line, width, result, parabolas, borders);
            for (int x = 0; x < width; x++) {
                clearance[y * width + x] = (float) (Math.sqrt(result[x]) * cellMeters);
            }
        }
    }

    /** The lower envelope of the parabolas at the values of one line. */
    private static void transform(float[] line, int count, float[] result, int[] parabolas, float[] borders) {
        int last = 0;
        parabolas[0] = 0;
        borders[0] = Float.NEGATIVE_INFINITY;
        borders[1] = Float.POSITIVE_INFINITY;
        for (int q = 1; q < count; q++) {
            float border = border(line, q, parabolas[last]);
            while (border <= borders[last]) {
                last--;
                border = border(line, q, parabolas[last]);
            }
            last++;
            parabolas[last] = q;
            borders[last] = border;
            borders[last + 1] = Float.POSITIVE_INFINITY;
        }
        int k = 0;
        for (int q = 0; q < count; q++) {
            while (borders[k + 1] < q) {
                k++;
            }
            float away = q - parabolas[k];
            result[q] = away * away + line[parabolas[k]];
        }
    }

    private static float border(float[] line, int q, int p) {
        double difference = (line[q] + (double) q * q) - (line[p] + (double) p * p);
        return (float) (difference / (2.0 * (q - p)));
    }

    // ---- cells -----------------------------------------------------------------------------------------------------

    int width() {
        return width;
    }

    int cells() {
        return clearance.length;
    }

    double cellMeters() {
        return cellMeters;
    }

    /** The cell of a position; -1 outside the world. */
    int cell(double x, double y) {
        int column = (int) Math.floor((x - left) / cellMeters);
        int row = (int) Math.floor((y - bottom) / cellMeters);
        return column < 0 || row < 0 || column >= width || row >= height ? -1 : row * width + column;
    }

    /** X of a cell's middle. */
    double xMeters(int cell) {
        return left + (cell % width + 0.5) * cellMeters;
    }

    /** Y of a cell's middle. */
    double yMeters(int cell) {
        return bottom + (cell / width + 0.5) * cellMeters;
    }

    Position position(int cell) {
        return new Position(xMeters(cell), yMeters(cell));
    }

    /** The distance of a cell from the nearest obstacle, exact to a cell's width. */
    double clearanceMeters(int cell) {
        return clearance[cell];
    }

    /** The clearance at a position; 0 outside the world. */
    double clearanceMeters(double x, double y) {
        int cell = cell(x, y);
        return cell < 0 ? 0 : clearance[cell];
    }
}
