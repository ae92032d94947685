package simgsm.center.bsc.handover;

/** The latest levels of one cell, at most {@link PowerBudgetDecision#MOST_RESULTS}. */
final class LevelWindow {
    private final int[] levels = new int[PowerBudgetDecision.MOST_RESULTS];
    private int count;

    void add(int level) {
        levels[count % levels.length] = level;
        count++;
    }

    /** The mean of the latest levels, truncated; of fewer than {@code window} if there are fewer. */
    int average(int window) {
        int size = Math.min(window, Math.min(count, levels.length));
        int sum = 0;
        for (int i = 1; i <= size; i++) {
            sum += levels[(count - i) % levels.length];
        }
        return size == 0 ? 0 : sum / size;
    }
}
