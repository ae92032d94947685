package simrobot.control;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import vericommand.Pose;
import vericommand.RobotStatus;

/**
 * One robot's poses and statuses over time, for running and recorded sessions alike. Samples are kept in blocks that
 * are only appended or dropped whole, so {@link #samples} copies one reference per 64 samples.
 */
public final class TrackSeries {
    /** Sampling period of a moving robot, in simulated time. */
    public static final long PERIOD_NANOS = 100_000_000;

    static final String HEADER = "time s,x m,y m,heading degrees,status";
    private static final int BLOCK_SAMPLES = 64;

    private static final class Block {
        private final long[] times = new long[BLOCK_SAMPLES];
        /** x, y and heading of each sample: metres and degrees. */
        private final double[] poses = new double[3 * BLOCK_SAMPLES];

        private final RobotStatus[] statuses = new RobotStatus[BLOCK_SAMPLES];

        private Pose pose(int i) {
            return new Pose(poses[3 * i], poses[3 * i + 1], poses[3 * i + 2]);
        }
    }

    /** The samples of a series at one instant; any thread may read them. */
    public static final class Samples {
        private final List<Block> blocks;
        private final int count;

        private Samples(List<Block> blocks, int count) {
            this.blocks = blocks;
            this.count = count;
        }

        /** Writes a header, then one line per sample: seconds, metres, and degrees anticlockwise from +X. */
        public void writeCsv(Appendable out) throws IOException {
            out.append(HEADER).append('\n');
            for (int i = 0; i < count; i++) {
                Block block = blocks.get(i / BLOCK_SAMPLES);
                int at = i % BLOCK_SAMPLES;
                writeRow(out, block.times[at], block.pose(at), block.statuses[at]);
            }
        }

        /** The text of {@link #writeCsv}. */
        public String csv() {
            StringBuilder text = new StringBuilder();
            try {
                writeCsv(text);
            } catch (IOException e) {
                throw new AssertionError("a StringBuilder throws no IOException", e);
            }
            return text.toString();
        }
    }

    /** Writes a line of CSV: seconds, metres, degrees anticlockwise from +X, and the status in words. */
    public static void writeRow(Appendable out, long timeNanos, Pose pose, RobotStatus status) throws IOException {
        out.append(String.format(Locale.ROOT, "%.2f", timeNanos * 1e-9))
                .append(',')
                .append(pose.xText(4))
                .append(',')
                .append(pose.yText(4))
                .append(',')
                .append(pose.headingText(2))
                .append(',')
                .append(status.text())
                .append('\n');
    }

    private final Deque<Block> blocks = new ArrayDeque<>();
    private int count;
    private long lastNanos;
    private Pose lastPose;
    private RobotStatus lastStatus;

    /** An empty series. */
    public TrackSeries() {}

    /** True if pose or status differ from the newest sample. */
    public boolean isNews(Pose pose, RobotStatus status) {
        return isNews(status) || !lastPose.equals(pose);
    }

    /** True if the status differs from the newest sample's, or there is none. */
    public boolean isNews(RobotStatus status) {
        return lastStatus != status;
    }

    /**
     * Adds a sample. After more than one period without one, the old pose is repeated just before it, so that readers do not
     * interpolate a slow motion.
     *
     * @param room maximum number of samples; the oldest are dropped beyond it
     */
    public void add(long timeNanos, Pose pose, RobotStatus status, int room) {
        if (count > 0 && timeNanos - lastNanos > PERIOD_NANOS) {
            append(timeNanos - PERIOD_NANOS, lastPose, lastStatus, room);
        }
        append(timeNanos, pose, status, room);
    }

    /** Adds a sample without repeating the old pose, as for a robot that was absent until now. */
    public void append(long timeNanos, Pose pose, RobotStatus status, int room) {
        int at = count % BLOCK_SAMPLES;
        if (at == 0) {
            while (count > 0 && count + BLOCK_SAMPLES > room) {
                blocks.removeFirst();
                count -= BLOCK_SAMPLES;
            }
            blocks.addLast(new Block());
        }
        Block block = blocks.getLast();
        block.times[at] = timeNanos;
        block.poses[3 * at] = pose.xMeters();
        block.poses[3 * at + 1] = pose.yMeters();
        block.poses[3 * at + 2] = pose.headingDegrees();
        block.statuses[at] = status;
        count++;
        lastNanos = timeNanos;
        lastPose = pose;
        lastStatus = status;
    }

    /** All samples so far; later ones do not change the result. */
    public Samples samples() {
        return new Samples(new ArrayList<>(blocks), count);
    }
}
