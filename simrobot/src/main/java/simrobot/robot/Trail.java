package simrobot.robot;

import java.util.Arrays;

/** Breadcrumbs: where a robot has been. Old ones make room, so a robot may run for weeks. */
public final class Trail {
    /** Points that are kept; at their spacing 80 m of way. */
    public static final int CAPACITY = 4000;

    private static final int FIRST_ROOM = 16;
    private static final double SPACING_METERS = 0.02;

    /**
     * The points, oldest first; immutable.
     *
     * @param xy x and y of each, metres; both NaN where the robot was lifted
     * @param timesNanos simulated time of each
     */
    public record Points(double[] xy, long[] timesNanos) {
        public static final Points NONE = new Points(new double[0], new long[0]);

        public int size() {
            return timesNanos.length;
        }
    }

    /** A ring that grows until it holds the most; most robots of a crowd never come so far. */
    private double[] xs = new double[FIRST_ROOM];

    private double[] ys = new double[FIRST_ROOM];
    private long[] times = new long[FIRST_ROOM];
    private int count;
    private int next;
    private Points published = Points.NONE;
    private boolean changed;

    /** No points yet. */
    public Trail() {}

    /** Drops a point when the robot has come a point's spacing from the last one. */
    public void pass(double x, double y, long timeNanos) {
        if (count == 0 || !isNear(x - xs[last()], y - ys[last()])) {
            add(x, y, timeNanos);
        }
    }

    private static boolean isNear(double dx, double dy) {
        return dx * dx + dy * dy < SPACING_METERS * SPACING_METERS;
    }

    /** The robot leaves the floor: no line leads from here to the next point. */
    void lift() {
        if (count > 0 && !Double.isNaN(xs[last()])) {
            add(Double.NaN, Double.NaN, times[last()]);
        }
    }

    public void clear() {
        count = 0;
        next = 0;
        changed = true;
    }

    private int last() {
        return (next + xs.length - 1) % xs.length;
    }

    /** A ring that is not full size yet has never gone round. */
    private void grow() {
        int room = Math.min(CAPACITY, 4 * xs.length);
        xs = Arrays.copyOf(xs, room);
        ys = Arrays.copyOf(ys, room);
        times = Arrays.copyOf(times, room);
        next = count;
    }

    private void add(double x, double y, long timeNanos) {
        if (count == xs.length && count < CAPACITY) {
            grow();
        }
        xs[next] = x;
        ys[next] = y;
        times[next] = timeNanos;
        next = (next + 1) % xs.length;
        count = Math.min(CAPACITY, count + 1);
        changed = true;
    }

    /** The points so far; the same object as long as nothing has changed. */
    public Points points() {
        if (changed) {
            double[] xy = new double[2 * count];
            long[] at = new long[count];
            for (int i = 0; i < count; i++) {
                int from = (next - count + i + xs.length) % xs.length;
                xy[2 * i] = xs[from];
                xy[2 * i + 1] = ys[from];
                at[i] = times[from];
            }
            published = new Points(xy, at);
            changed = false;
        }
        return published;
    }
}
