package simgsm.words;

/**
 * The distance of two words, aligned in time at the least cost (dynamic time warping): steps of one frame in either word
 * weigh 1, in both 2; the sum is divided by both lengths.
 */
final class TimeWarping {
    private static final double MOST_RATIO = 2.2;
    private static final double NONE = Double.POSITIVE_INFINITY;

    private TimeWarping() {}

    /** @return infinite if the lengths differ by more than 1 : 2.2 */
    static double distance(SpokenWord heard, SpokenWord template) {
        int n = heard.length();
        int m = template.length();
        if (n > MOST_RATIO * m || m > MOST_RATIO * n) {
            return NONE;
        }
        double[] before = new double[m];
        double[] sums = new double[m];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < m; j++) {
                double here = heard.distance(i, template, j);
                double both = i > 0 && j > 0 ? before[j - 1] + 2 * here : i + j == 0 ? 2 * here : NONE;
                double one = i > 0 ? before[j] + here : NONE;
                double other = j > 0 ? sums[j - 1] + here : NONE;
                sums[j] = Math.min(both, Math.min(one, other));
            }
            double[] swap = before;
            before = sums;
            sums = swap;
        }
        return before[m - 1] / (n + m);
    }
}
