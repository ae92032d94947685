package simgsm.center.journal;

import java.util.List;
import java.util.function.LongSupplier;

/**
 * Groups commits for one synchronisation. On a slow disk a group waits for as many commits as the last two had
 * together, at most a tenth of a synchronisation, so that senders who wait for each answer are answered together, not
 * in two alternating halves.
 */
final class CommitGroups<T> {
    /** Synchronisation time below which no group waits. */
    private static final long SLOW_NANOS = 10_000_000;

    private static final int SHARE = 10;

    /** Supplies commits. */
    interface Source<T> {
        /** The next commit; null after this time. */
        T next(long nanos) throws InterruptedException;
    }

    private final LongSupplier clock;
    private long syncNanos;
    private int last;
    private int beforeLast;

    CommitGroups(LongSupplier clock) {
        this.clock = clock;
    }

    /**
     * Adds commits after the first one of a group.
     *
     * @param most commits in a group
     */
    void gather(List<T> group, int most, Source<T> source) throws InterruptedException {
        long end = clock.getAsLong() + (syncNanos < SLOW_NANOS ? 0 : syncNanos / SHARE);
        int expected = last + beforeLast;
        T next;
        do {
            next = source.next(group.size() < expected ? Math.max(0, end - clock.getAsLong()) : 0);
            if (next != null) {
                group.add(next);
            }
        } while (next != null && group.size() < most);
    }

    /**
     * Notes a written group.
     *
     * @param nanos duration of the write
     */
    void written(int commits, long nanos) {
        beforeLast = last;
        last = commits;
        syncNanos = nanos;
    }
}
