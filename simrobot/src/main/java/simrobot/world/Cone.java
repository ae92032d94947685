package simrobot.world;

/**
 * The field of a sonar: the area between two rays from one place.
 *
 * <pre>
 *              left ray
 *            /
 *      apex &lt; - - axis
 *            \
 *              right ray
 * </pre>
 */
public final class Cone {
    private final double x;
    private final double y;
    private final double leftX;
    private final double leftY;
    private final double rightX;
    private final double rightY;

    /**
     * A cone with its apex at (x, y).
     *
     * @param axisRadians anticlockwise from +X
     * @param openingRadians between the two rays, below 180 degrees
     */
    public Cone(double x, double y, double axisRadians, double openingRadians) {
        this(
                x,
                y,
                Math.cos(axisRadians + openingRadians / 2),
                Math.sin(axisRadians + openingRadians / 2),
                Math.cos(axisRadians - openingRadians / 2),
                Math.sin(axisRadians - openingRadians / 2));
        if (!(openingRadians > 0 && openingRadians < Math.PI)) {
            throw new IllegalArgumentException("a cone opens by " + openingRadians + ", expected above 0 and below pi");
        }
    }

    /**
     * A cone between two rays.
     *
     * @param leftX with leftY the direction of the left ray, a unit vector; likewise the right ray, less than 180 degrees
     *     clockwise from it
     */
    public Cone(double x, double y, double leftX, double leftY, double rightX, double rightY) {
        this.x = x;
        this.y = y;
        this.leftX = leftX;
        this.leftY = leftY;
        this.rightX = rightX;
        this.rightY = rightY;
    }

    /** The distance of the apex from a position. */
    double apexDistance(double px, double py) {
        double fx = px - x;
        double fy = py - y;
        return Math.sqrt(fx * fx + fy * fy);
    }

    /** Quick test: false if the disc is certainly outside or farther than {@code within}. */
    public boolean mayHold(double px, double py, double radius, double within) {
        double fx = px - x;
        double fy = py - y;
        double reach = within + radius;
        return fx * leftY - fy * leftX >= -radius
                && rightX * fy - rightY * fx >= -radius
                && fx * fx + fy * fy <= reach * reach;
    }

    /** The distance to a point; infinite if it is outside. */
    public double distanceToPoint(double px, double py) {
        double fx = px - x;
        double fy = py - y;
        boolean inside = fx * leftY - fy * leftX >= 0 && rightX * fy - rightY * fx >= 0;
        return inside ? Math.sqrt(fx * fx + fy * fy) : Double.POSITIVE_INFINITY;
    }

    /** The distance to the nearest point of the segment's part inside; infinite if there is none. */
    public double distanceToSegment(double x1, double y1, double x2, double y2) {
        double ax = x1 - x;
        double ay = y1 - y;
        double bx = x2 - x;
        double by = y2 - y;
        double fromLeft = ax * leftY - ay * leftX;
        double toLeft = bx * leftY - by * leftX;
        if (fromLeft < 0 && toLeft < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double fromRight = rightX * ay - rightY * ax;
        double toRight = rightX * by - rightY * bx;
        if (fromRight < 0 && toRight < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double start = Math.max(entry(fromLeft, toLeft), entry(fromRight, toRight));
        double end = Math.min(exit(fromLeft, toLeft), exit(fromRight, toRight));
        if (start > end) {
            return Double.POSITIVE_INFINITY;
        }
        double sx = bx - ax;
        double sy = by - ay;
        return Distances.toSegment(0, 0, ax + start * sx, ay + start * sy, ax + end * sx, ay + end * sy);
    }

    /**
     * The share at which a value that runs from {@code from} to {@code to} over 0..1 becomes 0 or more; above 1 if it
     * never does.
     */
    private static double entry(double from, double to) {
        if (from >= 0) {
            return 0;
        }
        return to >= 0 ? from / (from - to) : 2;
    }

    private static double exit(double from, double to) {
        if (to >= 0) {
            return 1;
        }
        return from >= 0 ? from / (from - to) : -1;
    }
}
