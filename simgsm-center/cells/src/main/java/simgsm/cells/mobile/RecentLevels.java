package simgsm.cells.mobile;

/** The levels of a mobile's last ten measurements in a connection, averaged by controllers. */
public final class RecentLevels {
    private static final int KEPT = 10;

    private final double[][] kept;
    private int count;

    RecentLevels(int towers) {
        kept = new double[KEPT][towers];
    }

    void add(double[] levelsDbm) {
        System.arraycopy(levelsDbm, 0, kept[count % KEPT], 0, levelsDbm.length);
        count++;
    }

    void clear() {
        count = 0;
    }

    /** True if at least this number of measurements is kept; the list keeps ten. */
    public boolean has(int measurements) {
        return count >= measurements;
    }

    /** The average of a tower's latest measurements in dBm; of all kept ones if those are fewer. */
    public double averageDbm(int tower, int measurements) {
        int taken = Math.min(count, Math.min(measurements, KEPT));
        double sum = 0;
        for (int i = 0; i < taken; i++) {
            sum += kept[(count - 1 - i) % KEPT][tower];
        }
        return sum / Math.max(1, taken);
    }
}
