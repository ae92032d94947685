package simrobot.control;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import simrobot.robot.Pioneer;
import simrobot.simulation.Simulation;
import vericommand.Pose;
import vericommand.RobotStatus;

/**
 * Where every robot has been and in which status, ten times a simulated second while something changes; bounded, the oldest
 * make room. Filled on the simulation's thread, read by any.
 */
public final class TrackLog {
    static final String HEADER = "time s,x m,y m,heading degrees,status";

    private static final long PERIOD_NANOS = 100_000_000;
    private static final int MOST_SAMPLES = 2_000_000;
    private static final int LEAST_SAMPLES_OF_A_ROBOT = 1000;

    private final Simulation simulation;
    private final int mostSamples;
    private final Map<String, Series> tracks = new HashMap<>();

    TrackLog(Simulation simulation) {
        this(simulation, MOST_SAMPLES);
    }

    /** @param mostSamples of all robots together */
    TrackLog(Simulation simulation, int mostSamples) {
        this.simulation = simulation;
        this.mostSamples = mostSamples;
        simulation.addStepListener(this::step);
    }

    /** Follows a robot from now on; one of the same name that was there before is forgotten. */
    synchronized void follow(Pioneer robot) {
        Series series = new Series(robot);
        tracks.put(robot.name(), series);
        series.take(simulation.timeNanos(), room());
        robot.addStatusListener(status -> changed(series));
    }

    /** A robot that has left has no track any more. */
    synchronized void forget(Pioneer robot) {
        tracks.remove(robot.name());
    }

    private synchronized void changed(Series series) {
        series.take(simulation.timeNanos(), room());
    }

    private synchronized void step(long timeNanos) {
        if (timeNanos % PERIOD_NANOS == 0) {
            int room = room();
            for (Series series : tracks.values()) {
                if (series.isNews()) {
                    series.take(timeNanos, room);
                }
            }
        }
    }

    private int room() {
        return Math.max(LEAST_SAMPLES_OF_A_ROBOT, mostSamples / Math.max(1, tracks.size()));
    }

    /** A robot's track: a header, then a line for each sample; metres, and degrees anticlockwise from +X. Any thread may ask. */
    public synchronized String csv(String robot) {
        StringBuilder text = new StringBuilder(HEADER).append('\n');
        Series series = tracks.get(robot);
        if (series != null) {
            series.write(text);
        }
        return text.toString();
    }

    private static final class Series {
        private final Pioneer robot;
        private long[] times = new long[64];
        private double[] xs = new double[64];
        private double[] ys = new double[64];
        private double[] headings = new double[64];
        private RobotStatus[] statuses = new RobotStatus[64];
        private int count;

        Series(Pioneer robot) {
            this.robot = robot;
        }

        boolean isNews() {
            int last = count - 1;
            Pose pose = robot.pose();
            return xs[last] != pose.xMeters()
                    || ys[last] != pose.yMeters()
                    || headings[last] != pose.headingDegrees()
                    || statuses[last] != robot.status();
        }

        /** Who has stood for long is told to have stood until now: nobody is to think of a slow way. */
        void take(long timeNanos, int room) {
            int last = count - 1;
            if (last >= 0 && timeNanos - times[last] > PERIOD_NANOS) {
                add(timeNanos - PERIOD_NANOS, xs[last], ys[last], headings[last], statuses[last], room);
            }
            Pose pose = robot.pose();
            add(timeNanos, pose.xMeters(), pose.yMeters(), pose.headingDegrees(), robot.status(), room);
        }

        private void add(long timeNanos, double x, double y, double heading, RobotStatus status, int room) {
            if (count >= room) {
                drop(Math.max(1, count - room + room / 8));
            }
            if (count == times.length) {
                grow(2 * count);
            }
            times[count] = timeNanos;
            xs[count] = x;
            ys[count] = y;
            headings[count] = heading;
            statuses[count++] = status;
        }

        private void drop(int oldest) {
            count -= oldest;
            System.arraycopy(times, oldest, times, 0, count);
            System.arraycopy(xs, oldest, xs, 0, count);
            System.arraycopy(ys, oldest, ys, 0, count);
            System.arraycopy(headings, oldest, headings, 0, count);
            System.arraycopy(statuses, oldest, statuses, 0, count);
        }

        private void grow(int length) {
            times = Arrays.copyOf(times, length);
            xs = Arrays.copyOf(xs, length);
            ys = Arrays.copyOf(ys, length);
            headings = Arrays.copyOf(headings, length);
            statuses = Arrays.copyOf(statuses, length);
        }

        void write(StringBuilder text) {
            for (int i = 0; i < count; i++) {
                Pose pose = new Pose(xs[i], ys[i], headings[i]);
                text.append(String.format(Locale.ROOT, "%.2f", times[i] * 1e-9)).append(',');
                text.append(pose.xText(4)).append(',').append(pose.yText(4)).append(',');
                text.append(pose.headingText(2)).append(',');
                text.append(statuses[i].text()).append('\n');
            }
        }
    }
}
