package simgsm.center.journal;

import java.util.List;
import java.util.function.LongSupplier;

/**
 * Gathers commits that are written with one synchronisation. On a slow disk a group waits for as many commits as the last
 * two had together, for a tenth of a synchronisation at most: so senders who wait for an answer each are answered together,
 * and not one half of them after the other.
 */
final class CommitGroups<T> {
    /** On a faster disk no group waits. */
    private static final long SLOW_NANOS = 10_000_000;

    private static final int SHARE = 10;

    /** Where commits come from. */
    interface Source<T> {
        /** The next commit; null if none comes in this time. */
        T next(long nanos) throws InterruptedException;
    }

    private final LongSupplier clock;
    private long syncNanos;
    private int last;
    private int beforeLast;

    CommitGroups(LongSupplier clock) {
        this.clock = clock;
    }

    /** Adds what follows the first commit of a group. @param most commits in a group */
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

    /** A group was written. @param nanos what that took */
    void written(int commits, long nanos) {
        beforeLast = last;
        last = commits;
        syncNanos = nanos;
    }
}
