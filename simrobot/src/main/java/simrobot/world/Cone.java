package simrobot.world;

/**
 * What a sonar hears: everything between two rays from one place, its nearest part first.
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
    private final double axis;
    private final double half;
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
        if (!(openingRadians > 0 && openingRadians < Math.PI)) {
            throw new IllegalArgumentException("a cone opens by " + openingRadians + ", expected above 0 and below pi");
        }
        this.x = x;
        this.y = y;
        axis = axisRadians;
        half = openingRadians / 2;
        leftX = Math.cos(axis + half);
        leftY = Math.sin(axis + half);
        rightX = Math.cos(axis - half);
        rightY = Math.sin(axis - half);
    }

    /** Infinite when the point is not inside. */
    public double distanceToPoint(double px, double py) {
        double fx = px - x;
        double fy = py - y;
        boolean inside = fx * leftY - fy * leftX >= 0 && rightX * fy - rightY * fx >= 0;
        return inside ? Math.sqrt(fx * fx + fy * fy) : Double.POSITIVE_INFINITY;
    }

    /** To the nearest place of the segment's part that is inside; infinite when no part is. */
    public double distanceToSegment(double x1, double y1, double x2, double y2) {
        double ax = x1 - x;
        double ay = y1 - y;
        double bx = x2 - x;
        double by = y2 - y;
        double fromLeft = ax * leftY - ay * leftX;
        double toLeft = bx * leftY - by * leftX;
        double fromRight = rightX * ay - rightY * ax;
        double toRight = rightX * by - rightY * bx;
        double start = Math.max(entry(fromLeft, toLeft), entry(fromRight, toRight));
        double end = Math.min(exit(fromLeft, toLeft), exit(fromRight, toRight));
        if (start > end) {
            return Double.POSITIVE_INFINITY;
        }
        double sx = bx - ax;
        double sy = by - ay;
        return Distances.toSegment(0, 0, ax + start * sx, ay + start * sy, ax + end * sx, ay + end * sy);
    }

    /** Where a value that runs from {@code from} to {@code to} over 0..1 becomes 0 or more; above 1 when it never does. */
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

    /** The cone's upright bounds, cut off at this reach: least x. */
    public double minX(double reach) {
        return x + reach * lowest(axis);
    }

    public double maxX(double reach) {
        return x - reach * lowest(axis + Math.PI);
    }

    public double minY(double reach) {
        return y + reach * lowest(axis - Math.PI / 2);
    }

    public double maxY(double reach) {
        return y - reach * lowest(axis + Math.PI / 2);
    }

    /** The least cosine, at most 0 for the apex, over the cone turned to this axis. */
    private double lowest(double turnedAxis) {
        double toBack = Math.abs(Math.IEEEremainder(turnedAxis - Math.PI, 2 * Math.PI));
        return toBack <= half ? -1 : Math.min(0, Math.min(Math.cos(turnedAxis - half), Math.cos(turnedAxis + half)));
    }
}
