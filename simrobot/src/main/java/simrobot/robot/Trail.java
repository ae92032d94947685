package simrobot.robot;

import java.util.Arrays;

/** A robot's past positions, every 2 cm; at most 4000, the oldest are dropped. */
public final class Trail {
    /** Maximum number of points, for 80 m of path. */
    public static final int CAPACITY = 4000;

    private static final int INITIAL_SIZE = 16;
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

    /** A ring buffer that grows up to the capacity. */
    private double[] xs = new double[INITIAL_SIZE];

    private double[] ys = new double[INITIAL_SIZE];
    private long[] times = new long[INITIAL_SIZE];
    private int count;
    private int next;
    private Points published = Points.NONE;
    private boolean changed;

    /** A trail without points. */
    public Trail() {}

    /** Adds a point if the robot is 2 cm or more from the last one. */
    public void pass(double x, double y, long timeNanos) {
        if (count == 0 || !isNear(x - xs[last()], y - ys[last()])) {
            add(x, y, timeNanos);
        }
    }

    private static boolean isNear(double dx, double dy) {
        return dx * dx + dy * dy < SPACING_METERS * SPACING_METERS;
    }

    /** Interrupts the line because the robot is lifted. */
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

    /** the ring has not wrapped around below its capacity */
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

    /** The points so far; the same object until a new one. */
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
