package simgsm.words;

import java.util.ArrayList;
import java.util.List;

/**
 * The distance of two words, aligned in time at the least cost (dynamic time warping): steps of one frame in either word
 * weigh 1, in both 2; the sum is divided by both lengths.
 */
final class TimeWarping {
    private static final double MOST_LENGTH_RATIO = 2.2;
    private static final double NONE = Double.POSITIVE_INFINITY;

    private TimeWarping() {}

    /** False if the lengths differ by more than 1 : 2.2: these are different words. */
    static boolean fits(SpokenWord heard, SpokenWord template) {
        return heard.length() <= MOST_LENGTH_RATIO * template.length()
                && template.length() <= MOST_LENGTH_RATIO * heard.length();
    }

    static double distance(SpokenWord heard, SpokenWord template) {
        int n = heard.length();
        int m = template.length();
        double[] sums = row(heard, template, 0, new double[m]);
        for (int i = 1; i < n; i++) {
            sums = row(heard, template, i, sums);
        }
        return sums[m - 1] / (n + m);
    }

    /** The least sums up to frame i of the word and each of the template. @param before those of the frame before */
    private static double[] row(SpokenWord heard, SpokenWord template, int i, double[] before) {
        double[] sums = new double[before.length];
        for (int j = 0; j < sums.length; j++) {
            double here = heard.distance(i, template, j);
            double both = i > 0 && j > 0 ? before[j - 1] + 2 * here : i + j == 0 ? 2 * here : NONE;
            double one = i > 0 ? before[j] + here : NONE;
            double other = j > 0 ? sums[j - 1] + here : NONE;
            sums[j] = Math.min(both, Math.min(one, other));
        }
        return sums;
    }

    /** The last aligned frame of the template for each frame of the word, 0 to 1. */
    static List<Double> path(SpokenWord heard, SpokenWord template) {
        int n = heard.length();
        int last = template.length() - 1;
        double[][] sums = new double[n][];
        for (int i = 0; i < n; i++) {
            sums[i] = row(heard, template, i, i == 0 ? new double[last + 1] : sums[i - 1]);
        }
        List<Double> path = new ArrayList<>();
        int j = last;
        for (int i = n - 1; i >= 0; i--) {
            path.add(0, j / (double) Math.max(1, last));
            // back over the steps whose sum this is: within the template, then one in the word, or in both
            while (i > 0 && j > 0 && sums[i][j] == sums[i][j - 1] + heard.distance(i, template, j)) {
                j--;
            }
            if (i > 0 && j > 0 && sums[i][j] == sums[i - 1][j - 1] + 2 * heard.distance(i, template, j)) {
                j--;
            }
        }
        return path;
    }
}
