package simgsm.cells.mobile;

/** The levels of the last ten measurements, which controllers average, of one mobile in a connection. */
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

    /** Whether there are ten. */
    public boolean isComplete() {
        return count >= KEPT;
    }

    /** The average of a tower in dBm; of fewer measurements if there are no ten. */
    public double averageDbm(int tower) {
        int taken = Math.min(count, KEPT);
        double sum = 0;
        for (int i = 0; i < taken; i++) {
            sum += kept[i][tower];
        }
        return sum / Math.max(1, taken);
    }
}
