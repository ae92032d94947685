package simgsm.words;

import java.util.ArrayList;
import java.util.List;

/**
 * The distance of two words, aligned in time at the least cost (dynamic time warping): steps of one frame in either word
 * weigh 1, in both 2; the sum is divided by both lengths.
 */
final class TimeWarping {
    private static final double MOST_RATIO = 2.2;
    private static final double NONE = Double.POSITIVE_INFINITY;

    private TimeWarping() {}

    /** False if the lengths differ by more than 1 : 2.2: these are different words. */
    static boolean fits(SpokenWord heard, SpokenWord template) {
        return heard.length() <= MOST_RATIO * template.length() && template.length() <= MOST_RATIO * heard.length();
    }

    static double distance(SpokenWord heard, SpokenWord template) {
        int n = heard.length();
        int m = template.length();
        return sums(heard, template)[n - 1][m - 1] / (n + m);
    }

    /** The aligned frame of the template for each frame of the word, 0 to 1. */
    static List<Double> path(SpokenWord heard, SpokenWord template) {
        double[][] sums = sums(heard, template);
        List<Double> path = new ArrayList<>();
        int j = template.length() - 1;
        for (int i = sums.length - 1; i >= 0; i--) {
            path.add(0, j / (double) Math.max(1, template.length() - 1));
            // back to where the least sum came from: steps within the template first, then one in the word
            while (j > 0 && (i == 0 || sums[i][j - 1] < Math.min(sums[i - 1][j], sums[i - 1][j - 1]))) {
                j--;
            }
            j -= i > 0 && j > 0 && sums[i - 1][j - 1] <= sums[i - 1][j] ? 1 : 0;
        }
        return path;
    }

    /** The least sums up to each pair of frames. */
    private static double[][] sums(SpokenWord heard, SpokenWord template) {
        int n = heard.length();
        int m = template.length();
        double[][] sums = new double[n][m];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < m; j++) {
                double here = heard.distance(i, template, j);
                double both = i > 0 && j > 0 ? sums[i - 1][j - 1] + 2 * here : i + j == 0 ? 2 * here : NONE;
                double one = i > 0 ? sums[i - 1][j] + here : NONE;
                double other = j > 0 ? sums[i][j - 1] + here : NONE;
                sums[i][j] = Math.min(both, Math.min(one, other));
            }
        }
        return sums;
    }
}
