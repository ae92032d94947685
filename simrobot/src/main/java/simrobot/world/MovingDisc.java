package simrobot.world;

/**
 * Continuous collision detection for a disc on a straight path: no obstacle is skipped, whatever the path's length.
 *
 * <p>The disc stops when its rim is {@link #SKIN_METERS} short of the obstacle. Within that distance an obstacle blocks
 * only motion towards it; motion away from it and along it remains free, whatever the rounding.
 */
public final class MovingDisc {
    /** The gap left at a contact, so that rounding never puts the rim inside the wall. */
    public static final double SKIN_METERS = 1e-7;

    /** Motion is towards an obstacle if its cosine with the normal is below this: above rounding error, below any real angle. */
    private static final double TOWARDS = -1e-11;

    private final double x;
    private final double y;
    private final double dx;
    private final double dy;
    private final double reach;
    private final double length;
    private double fraction = 1;
    private double normalX;
    private double normalY;
    private boolean touched;

    /** A disc of this radius with its centre at (x, y), on a path by (dx, dy); metres. */
    public MovingDisc(double x, double y, double dx, double dy, double radiusMeters) {
        this.x = x;
        this.y = y;
        this.dx = dx;
        this.dy = dy;
        this.reach = radiusMeters + SKIN_METERS;
        this.length = Math.sqrt(dx * dx + dy * dy);
    }

    /** The earliest contact with the obstacles so far. */
    public Contact contact() {
        return touched ? new Contact(fraction, normalX, normalY) : Contact.NONE;
    }

    /** Adds a wall. */
    public void addSegment(double x1, double y1, double x2, double y2) {
        if (isBeside(x1, x2, x, dx) || isBeside(y1, y2, y, dy)) {
            return;
        }
        double ux = x2 - x1;
        double uy = y2 - y1;
        double wall = Math.sqrt(ux * ux + uy * uy);
        if (wall > 0) {
            addFlank(x1, y1, ux / wall, uy / wall, wall);
        }
        addPoint(x1, y1);
        addPoint(x2, y2);
    }

    /** True if, along one axis, the wall is entirely on one side of the swept area. */
    private boolean isBeside(double wall1, double wall2, double from, double way) {
        return Math.max(wall1, wall2) < Math.min(from, from + way) - reach
                || Math.min(wall1, wall2) > Math.max(from, from + way) + reach;
    }

    /** Tests the wall's two long sides, without its ends. */
    private void addFlank(double x1, double y1, double ux, double uy, double wall) {
        double fx = x - x1;
        double fy = y - y1;
        double height = ux * fy - uy * fx;
        double side = height < 0 ? -1 : 1;
        double nx = -uy * side;
        double ny = ux * side;
        double gap = Math.abs(height) - reach;
        double approach = dx * nx + dy * ny;
        if (approach >= TOWARDS * length) {
            return;
        }
        double t = gap <= 0 ? 0 : gap / -approach;
        double along = (fx + t * dx) * ux + (fy + t * dy) * uy;
        if (along >= 0 && along <= wall) {
            touch(t, nx, ny);
        }
    }

    /** Adds a point. */
    public void addPoint(double px, double py) {
        addDisc(px, py, 0);
    }

    /** Adds another disc, at rest. */
    public void addDisc(double px, double py, double radiusMeters) {
        double fx = x - px;
        double fy = y - py;
        double b = fx * dx + fy * dy;
        double distance = Math.sqrt(fx * fx + fy * fy);
        if (b >= TOWARDS * length * distance) {
            return;
        }
        double sum = reach + radiusMeters;
        double a = length * length;
        double c = (distance - sum) * (distance + sum);
        double discriminant = b * b - a * c;
        if (c > 0 && discriminant < 0) {
            return;
        }
        double t = c <= 0 ? 0 : c / (-b + Math.sqrt(discriminant));
        double hx = fx + t * dx;
        double hy = fy + t * dy;
        double hit = Math.sqrt(hx * hx + hy * hy);
        touch(t, hit > 0 ? hx / hit : 1, hit > 0 ? hy / hit : 0);
    }

    private void touch(double t, double nx, double ny) {
        if (t < fraction || (t <= 1 && !touched)) {
            touched = true;
            fraction = t;
            normalX = nx;
            normalY = ny;
        }
    }
}
