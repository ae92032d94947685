package simgsm.center.msc;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import simgsm.air.Direction;
import simgsm.air.OctetString;
import simgsm.center.timer.Timers;

/** The latest signalling messages; older ones are forgotten. */
final class Ladder implements Trace {
    static final int MAX_ENTRIES = 1_000;

    private final Instant startedAt;
    private final Timers timers;
    private final Deque<LadderEntry> entries = new ArrayDeque<>(MAX_ENTRIES);
    private long passed;

    Ladder(Instant startedAt, Timers timers) {
        this.startedAt = startedAt;
        this.timers = timers;
    }

    @Override
    public void passed(Link link, Direction direction, String name, OctetString octets) {
        if (entries.size() == MAX_ENTRIES) {
            entries.removeFirst();
        }
        boolean up = direction == Direction.UPLINK;
        entries.addLast(new LadderEntry(
                startedAt.plusNanos(timers.nowNanos()),
                up ? link.name() : LadderEntry.CENTER,
                up ? LadderEntry.CENTER : link.name(),
                name,
                octets));
        passed++;
    }

    /** All messages since the start, those forgotten too. */
    long passedCount() {
        return passed;
    }

    List<LadderEntry> entries() {
        return List.copyOf(entries);
    }
}
