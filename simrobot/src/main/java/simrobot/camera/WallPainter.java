package simrobot.camera;

import java.util.Arrays;
import java.util.List;
import simrobot.world.Point;
import simrobot.world.Segment;
import simrobot.world.World;

/**
 * Draws the walls and posts of a world. All have one height, above the eye, so only the nearest is visible in each
 * column: a first pass finds it, a second draws it.
 */
final class WallPainter {
    static final double HEIGHT_METERS = 1.0;

    private static final int WALL = 0xEFE9DC;
    private static final int CAP = 0xC7BFAE;
    private static final int SKIRTING = 0x6E655A;
    private static final int EDGE = 0xA79F8F;
    private static final int POST = 0xD9D2C3;
    private static final double CAP_METERS = 0.03;
    private static final double SKIRTING_METERS = 0.07;
    private static final double EDGE_METERS = 0.012;

    /** Maximum visible distance; beyond it haze covers everything. */
    static final double RANGE_METERS = 80;

    /** Minimum post radius; thinner posts would flicker. */
    private static final double LEAST_POST_METERS = 0.01;

    private final double[] segments;
    /** Walls of scanned points, see {@link ScannedWalls}. */
    private final double[] pieces;

    private final double[] points;
    private final double postRadius;

    WallPainter(World world) {
        List<Segment> walls = world.items(Segment.class);
        segments = new double[4 * walls.size()];
        for (int i = 0; i < walls.size(); i++) {
            Segment wall = walls.get(i);
            segments[4 * i] = wall.x1Meters();
            segments[4 * i + 1] = wall.y1Meters();
            segments[4 * i + 2] = wall.x2Meters();
            segments[4 * i + 3] = wall.y2Meters();
        }
        ScannedWalls scanned = new ScannedWalls(world.items(Point.class));
        pieces = scanned.pieces();
        points = scanned.single();
        postRadius = Math.max(LEAST_POST_METERS, world.pointDiameterMeters() / 2);
    }

    void paint(PixelBuffer canvas, PinholeView eye) {
        Nearest nearest = new Nearest(eye);
        for (int i = 0; i < segments.length; i += 4) {
            nearest.wall(segments, i);
        }
        for (int i = 0; i < pieces.length; i += ScannedWalls.NUMBERS) {
            nearest.piece(pieces, i);
        }
        for (int i = 0; i < points.length; i += 2) {
            nearest.post(points[i], points[i + 1], postRadius);
        }
        for (int c = 0; c < canvas.width; c++) {
            if (nearest.depth[c] < RANGE_METERS) {
                column(canvas, eye, nearest, c);
            }
        }
    }

    /** The nearest wall or post of each column. */
    private static final class Nearest {
        final PinholeView eye;
        /** The slope, left / ahead, at the picture's edges. */
        final double edgeSlope;

        final double[] depth;
        final int[] colour;
        final double[] brightness;

        Nearest(PinholeView eye) {
            this.eye = eye;
            edgeSlope = eye.width() / 2.0 / eye.focal();
            depth = new double[eye.width()];
            colour = new int[eye.width()];
            brightness = new double[eye.width()];
            Arrays.fill(depth, RANGE_METERS);
        }

        void wall(double[] s, int i) {
            double a1 = eye.ahead(s[i], s[i + 1]);
            double a2 = eye.ahead(s[i + 2], s[i + 3]);
            if (Math.min(a1, a2) > RANGE_METERS) {
                return;
            }
            double l1 = eye.left(s[i], s[i + 1]);
            double l2 = eye.left(s[i + 2], s[i + 3]);
            ColumnRange columns = ColumnRange.of(eye, a1, l1, a2, l2);
            if (columns.first() > columns.last()) {
                return;
            }
            double length = Math.hypot(a2 - a1, l2 - l1);
            double lit = FaceBrightness.towards(eye, s[i], s[i + 1], s[i + 2], s[i + 3]);
            for (int c = columns.first(); c <= columns.last(); c++) {
                double share = ColumnRange.share(eye.slope(c), a1, l1, a2, l2);
                double ahead = a1 + share * (a2 - a1);
                if (ahead < depth[c]) {
                    double toEnd = Math.min(share, 1 - share) * length;
                    set(c, ahead, toEnd < Math.max(EDGE_METERS, ahead / eye.focal()) ? EDGE : WALL, lit);
                }
            }
        }

        /** Draws a piece of a wall, without edges. */
        void piece(double[] s, int i) {
            double a1 = eye.ahead(s[i], s[i + 1]);
            double a2 = eye.ahead(s[i + 2], s[i + 3]);
            if (Math.max(a1, a2) < PinholeView.NEAR_METERS || Math.min(a1, a2) > RANGE_METERS) {
                return;
            }
            double l1 = eye.left(s[i], s[i + 1]);
            double l2 = eye.left(s[i + 2], s[i + 3]);
            boolean isBeside =
                    l1 > a1 * edgeSlope && l2 > a2 * edgeSlope || l1 < -a1 * edgeSlope && l2 < -a2 * edgeSlope;
            if (isBeside) {
                return;
            }
            ColumnRange columns = ColumnRange.of(eye, a1, l1, a2, l2);
            if (columns.first() > columns.last()) {
                return;
            }
            double lit = FaceBrightness.towards(eye, s[i], s[i + 1], s[i] + s[i + 4], s[i + 1] + s[i + 5]);
            for (int c = columns.first(); c <= columns.last(); c++) {
                double ahead = a1 + ColumnRange.share(eye.slope(c), a1, l1, a2, l2) * (a2 - a1);
                if (ahead < depth[c]) {
                    set(c, ahead, WALL, lit);
                }
            }
        }

        void post(double px, double py, double radius) {
            double ahead = eye.ahead(px, py);
            if (ahead < PinholeView.NEAR_METERS || ahead > RANGE_METERS) {
                return;
            }
            double left = eye.left(px, py);
            double middle = eye.column(ahead, left);
            double half = Math.max(0.5, eye.focal() * radius / ahead);
            int last = (int) Math.min(eye.width() - 1.0, Math.ceil(middle + half - 0.5) - 1);
            for (int c = (int) Math.max(0, Math.ceil(middle - half - 0.5)); c <= last; c++) {
                if (ahead < depth[c]) {
                    double across = (c + 0.5 - middle) / half;
                    set(c, ahead, POST, 1 - 0.25 * across * across);
                }
            }
        }

        private void set(int c, double ahead, int rgb, double lit) {
            depth[c] = Math.max(PinholeView.NEAR_METERS, ahead);
            colour[c] = rgb;
            brightness[c] = lit;
        }
    }

    private static void column(PixelBuffer canvas, PinholeView eye, Nearest nearest, int c) {
        double ahead = nearest.depth[c];
        double clear = Shading.clear(ahead);
        int body = Shading.hazed(Shading.shaded(nearest.colour[c], nearest.brightness[c]), clear);
        int cap = Shading.hazed(Shading.shaded(CAP, nearest.brightness[c]), clear);
        int skirting = Shading.hazed(Shading.shaded(SKIRTING, nearest.brightness[c]), clear);
        int top = row(canvas, eye, ahead, HEIGHT_METERS);
        int capEnd = row(canvas, eye, ahead, HEIGHT_METERS - CAP_METERS);
        int skirt = row(canvas, eye, ahead, SKIRTING_METERS);
        int bottom = row(canvas, eye, ahead, 0);
        for (int r = top; r < bottom; r++) {
            int at = r * canvas.width + c;
            canvas.rgb[at] = r < capEnd ? cap : r < skirt ? body : skirting;
            canvas.depth[at] = (float) ahead;
        }
    }

    private static int row(PixelBuffer canvas, PinholeView eye, double ahead, double z) {
        return (int) Math.max(0, Math.min(canvas.height, Math.ceil(eye.row(ahead, z) - 0.5)));
    }
}
