package simrobot.control;

import java.util.Arrays;
import java.util.Locale;
import vericommand.Pose;
import vericommand.RobotStatus;

/** Where one robot has been and in which status, sample by sample; as CSV the same of a running and of a recorded session. */
public final class TrackSeries {
    /** What moves is sampled this often. */
    public static final long PERIOD_NANOS = 100_000_000;

    static final String HEADER = "time s,x m,y m,heading degrees,status";

    private long[] times = new long[64];
    private double[] xs = new double[64];
    private double[] ys = new double[64];
    private double[] headings = new double[64];
    private RobotStatus[] statuses = new RobotStatus[64];
    private int count;

    /** Whether it differs from the newest sample. */
    public boolean isNews(Pose pose, RobotStatus status) {
        int last = count - 1;
        return last < 0
                || xs[last] != pose.xMeters()
                || ys[last] != pose.yMeters()
                || headings[last] != pose.headingDegrees()
                || statuses[last] != status;
    }

    /** Whether the newest sample has another status than this, or there is none. */
    public boolean isNews(RobotStatus status) {
        return count == 0 || statuses[count - 1] != status;
    }

    /**
     * Takes a sample. Who has stood for long is told to have stood until now: nobody is to think of a slow way.
     *
     * @param room for so many samples; the oldest make room
     */
    public void take(long timeNanos, Pose pose, RobotStatus status, int room) {
        int last = count - 1;
        if (last >= 0 && timeNanos - times[last] > PERIOD_NANOS) {
            add(timeNanos - PERIOD_NANOS, xs[last], ys[last], headings[last], statuses[last], room);
        }
        appear(timeNanos, pose, status, room);
    }

    /** Takes the sample of one that was not there just before: nothing is said of the time between. */
    public void appear(long timeNanos, Pose pose, RobotStatus status, int room) {
        add(timeNanos, pose.xMeters(), pose.yMeters(), pose.headingDegrees(), status, room);
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

    /** A header, then a line for each sample; seconds, metres, and degrees anticlockwise from +X. */
    public String csv() {
        StringBuilder text = new StringBuilder(HEADER).append('\n');
        for (int i = 0; i < count; i++) {
            Pose pose = new Pose(xs[i], ys[i], headings[i]);
            text.append(String.format(Locale.ROOT, "%.2f", times[i] * 1e-9)).append(',');
            text.append(pose.xText(4)).append(',').append(pose.yText(4)).append(',');
            text.append(pose.headingText(2)).append(',');
            text.append(statuses[i].text()).append('\n');
        }
        return text.toString();
    }
}
