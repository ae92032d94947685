package simgsm.timer;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;

/** Counts the acts of the last minute or hour by their author, such as wrong passwords by address. */
public final class RecentCounts {
    private final int most;
    private final long windowNanos;
    private final Map<String, Deque<Long>> times = new BoundedMap<>();

    /** @param most acts of one author within the window */
    public RecentCounts(int most, long windowNanos) {
        this.most = most;
        this.windowNanos = windowNanos;
    }

    public void count(String author, long nowNanos) {
        times.computeIfAbsent(author, it -> new ArrayDeque<>()).addLast(nowNanos);
    }

    /** True once the window holds the most acts of this author. */
    public boolean isFull(String author, long nowNanos) {
        Deque<Long> recent = times.get(author);
        if (recent == null) {
            return false;
        }
        while (!recent.isEmpty() && nowNanos - recent.getFirst() >= windowNanos) {
            recent.removeFirst();
        }
        return recent.size() >= most;
    }
}
