package simrobot.robot;

/** Breadcrumbs: where a robot has been. Old ones make room, so a robot may run for weeks. */
public final class Trail {
    /** Crumbs that are kept; at their spacing 80 m of way. */
    public static final int CAPACITY = 4000;

    private static final double SPACING_METERS = 0.02;

    /**
     * The crumbs, oldest first; immutable.
     *
     * @param xy x and y of each, metres; both NaN where the robot was lifted
     * @param timesNanos simulated time of each
     */
    public record Crumbs(double[] xy, long[] timesNanos) {
        public static final Crumbs NONE = new Crumbs(new double[0], new long[0]);

        public int size() {
            return timesNanos.length;
        }
    }

    private final double[] xs = new double[CAPACITY];
    private final double[] ys = new double[CAPACITY];
    private final long[] times = new long[CAPACITY];
    private int count;
    private int next;
    private Crumbs published = Crumbs.NONE;
    private boolean changed;

    /** No crumbs yet. */
    public Trail() {}

    /** Drops a crumb when the robot has come a crumb's spacing from the last one. */
    public void pass(double x, double y, long timeNanos) {
        int last = (next + CAPACITY - 1) % CAPACITY;
        if (count == 0 || !(Math.hypot(x - xs[last], y - ys[last]) < SPACING_METERS)) {
            add(x, y, timeNanos);
        }
    }

    /** The robot leaves the floor: no line leads from here to the next crumb. */
    void lift() {
        if (count > 0 && !Double.isNaN(xs[(next + CAPACITY - 1) % CAPACITY])) {
            add(Double.NaN, Double.NaN, times[(next + CAPACITY - 1) % CAPACITY]);
        }
    }

    public void clear() {
        count = 0;
        changed = true;
    }

    private void add(double x, double y, long timeNanos) {
        xs[next] = x;
        ys[next] = y;
        times[next] = timeNanos;
        next = (next + 1) % CAPACITY;
        count = Math.min(CAPACITY, count + 1);
        changed = true;
    }

    /** The crumbs so far; the same object as long as nothing has changed. */
    public Crumbs crumbs() {
        if (changed) {
            double[] xy = new double[2 * count];
            long[] at = new long[count];
            for (int i = 0; i < count; i++) {
                int from = (next - count + i + CAPACITY) % CAPACITY;
                xy[2 * i] = xs[from];
                xy[2 * i + 1] = ys[from];
                at[i] = times[from];
            }
            published = new Crumbs(xy, at);
            changed = false;
        }
        return published;
    }
}
