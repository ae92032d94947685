package simgsm.tools.load;

/** A histogram of delays of up to 20 s, in steps of 10 µs. */
final class DelayHistogram {
    private static final int STEP_NANOS = 10_000;
    private static final int STEPS = 2_000_000;

    private final int[] counts = new int[STEPS];
    private long total;

    void add(long nanos) {
        int step = (int) Math.min(STEPS - 1, Math.max(0, nanos) / STEP_NANOS);
        counts[step]++;
        total++;
    }

    long count() {
        return total;
    }

    /**
     * A quantile, in milliseconds; 0 without delays.
     *
     * @param share above 0, at most 1: 0.5 is the median
     */
    double millis(double share) {
        long rest = (long) Math.ceil(share * total);
        for (int step = 0; step < STEPS && rest > 0; step++) {
            rest -= counts[step];
            if (rest <= 0) {
                return (step + 1) * (STEP_NANOS / 1e6);
            }
        }
        return 0;
    }
}
