package simgsm.center.net;

import java.util.Comparator;
import java.util.PriorityQueue;

/** The connections that have more to hand on than their turn allowed, and when each goes on. */
final class FairReadQueue {
    /** Whoever was too fast rests so long; at most a few hundredths of a second's allowance come together meanwhile. */
    static final long REST_NANOS = 10_000_000;

    private record Turn(long atNanos, long number, Connection connection) {}

    private final PriorityQueue<Turn> queue =
            new PriorityQueue<>(Comparator.comparingLong(Turn::atNanos).thenComparingLong(Turn::number));
    private long count;

    void add(Connection connection, RateLimitedFrameReader.Rest rest, long nowNanos) {
        long at = rest == RateLimitedFrameReader.Rest.FOR_LATER ? nowNanos + REST_NANOS : nowNanos;
        queue.add(new Turn(at, count++, connection));
    }

    /** When the next one goes on. */
    long dueNanos() {
        return queue.isEmpty() ? Long.MAX_VALUE : queue.peek().atNanos;
    }

    /** The next one whose time has come; null if there is none. Who is added meanwhile comes behind those who wait. */
    Connection next(long nowNanos) {
        return dueNanos() <= nowNanos ? queue.poll().connection : null;
    }

    int size() {
        return queue.size();
    }
}
