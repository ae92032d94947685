package simgsm.gateway.sip;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** Slows the guessing of passwords: 10 wrong ones a minute from one address; then all of its requests are refused unread. */
final class PasswordGuesses {
    private static final int MOST = 10;
    private static final long WINDOW_NANOS = TimeUnit.MINUTES.toNanos(1);

    private final Map<String, Deque<Long>> wrong = new NewestEntries<>();

    void count(String host, long nowNanos) {
        wrong.computeIfAbsent(host, it -> new ArrayDeque<>()).addLast(nowNanos);
    }

    boolean areTooMany(String host, long nowNanos) {
        Deque<Long> times = wrong.get(host);
        if (times == null) {
            return false;
        }
        while (!times.isEmpty() && nowNanos - times.getFirst() >= WINDOW_NANOS) {
            times.removeFirst();
        }
        return times.size() >= MOST;
    }
}
