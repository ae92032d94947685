package simrobot.world;

/** Distances in the plane; metres, directions as unit vectors. */
public final class Distances {
    private Distances() {}

    /** From a point to a segment. */
    public static double toSegment(double x, double y, double x1, double y1, double x2, double y2) {
        double ux = x2 - x1;
        double uy = y2 - y1;
        double square = ux * ux + uy * uy;
        double t = square > 0 ? ((x - x1) * ux + (y - y1) * uy) / square : 0;
        double inside = Math.max(0, Math.min(1, t));
        double dx = x1 + inside * ux - x;
        double dy = y1 + inside * uy - y;
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Along a ray to a segment; infinite when it misses. A ray parallel to the segment misses it. */
    public static double alongRay(
            double x, double y, double ux, double uy, double x1, double y1, double x2, double y2) {
        double sx = x2 - x1;
        double sy = y2 - y1;
        double cross = ux * sy - uy * sx;
        if (cross == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double fx = x1 - x;
        double fy = y1 - y;
        double t = fx * sy - fy * sx;
        double s = fx * uy - fy * ux;
        // hit if 0 <= t and 0 <= s <= cross, for positive cross; tested by sign bits, which avoids mispredicted
        // branches
        double sign = Math.copySign(1, cross);
        double ahead = t * sign + 0.0;
        double along = s * sign + 0.0;
        double beyond = cross * sign - along;
        long missed = Double.doubleToRawLongBits(ahead)
                | Double.doubleToRawLongBits(along)
                | Double.doubleToRawLongBits(beyond);
        return missed < 0 || cross == 0 ? Double.POSITIVE_INFINITY : t / cross;
    }

    /** Along a ray to the rim of a disc; 0 from inside, infinite when it misses. */
    public static double alongRayToDisc(double x, double y, double ux, double uy, double px, double py, double radius) {
        double fx = px - x;
        double fy = py - y;
        double middle = fx * ux + fy * uy;
        double c = fx * fx + fy * fy - radius * radius;
        double discriminant = middle * middle - c;
        if (discriminant < 0) {
            return Double.POSITIVE_INFINITY;
        }
        if (c <= 0) {
            return 0;
        }
        return middle > 0 ? middle - Math.sqrt(discriminant) : Double.POSITIVE_INFINITY;
    }
}
