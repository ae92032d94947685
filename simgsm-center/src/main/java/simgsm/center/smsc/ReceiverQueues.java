package simgsm.center.smsc;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** The queues of all destinations with entries. */
final class ReceiverQueues {
    /** Creates the collections that grow with the number of messages; a test counts the accesses to them. */
    interface Containers {
        Containers STANDARD = new Containers() {};

        default <K, V> Map<K, V> inOrderOfInsertion() {
            return new LinkedHashMap<>();
        }

        default <K, V> NavigableMap<K, V> sorted() {
            return new TreeMap<>();
        }
    }

    /** Destinations checked at once by {@link #available(Predicate)}, before a pause. */
    static final int SCANNED_AT_ONCE = 1_000;

    private static final long SCAN_PAUSE_NANOS = Duration.ofMillis(1).toNanos();

    private final ReceiverQueue.Context context;
    private final NavigableMap<Destination, ReceiverQueue> queues;
    private final Deque<Predicate<Destination>> scans = new ArrayDeque<>();

    ReceiverQueues(ReceiverQueue.Context context) {
        this.context = context;
        queues = context.containers().sorted();
    }

    /** Number of a destination's messages and reports, including reserved places. */
    int size(Destination destination) {
        ReceiverQueue queue = queues.get(destination);
        return queue == null ? 0 : queue.size();
    }

    /** The queue of a destination, created if missing. */
    ReceiverQueue of(Destination destination) {
        return queues.computeIfAbsent(destination, absent -> new ReceiverQueue(absent, context));
    }

    void removeIfEmpty(Destination destination) {
        ReceiverQueue queue = queues.get(destination);
        if (queue != null && queue.size() == 0) {
            queues.remove(destination);
            context.port().emptied(destination);
        }
    }

    /** The entries of all queues that will be tried. */
    Stream<QueueEntry> entries() {
        return queues.values().stream().flatMap(ReceiverQueue::entries);
    }

    /** Handles a receiver's availability. */
    void available(Destination destination) {
        ReceiverQueue queue = queues.get(destination);
        if (queue != null) {
            queue.receiverAvailable();
        }
    }

    /** Uses new space on the route to a destination. */
    void roomFor(Destination destination) {
        ReceiverQueue queue = queues.get(destination);
        if (queue != null) {
            queue.attempt();
        }
    }

    /**
     * Handles the availability of all destinations of a kind: checks the first {@link #SCANNED_AT_ONCE} now, and the
     * same number every further millisecond.
     */
    void available(Predicate<Destination> destinations) {
        scans.add(destinations);
        if (scans.size() == 1) {
            scan(queues.firstEntry());
        }
    }

    /** Checks the queues from this entry on for the oldest scan. */
    private void scan(Map.Entry<Destination, ReceiverQueue> from) {
        Map.Entry<Destination, ReceiverQueue> next = from;
        for (int i = 0; i < SCANNED_AT_ONCE && next != null; i++) {
            if (scans.element().test(next.getKey())) {
                next.getValue().receiverAvailable();
            }
            next = queues.higherEntry(next.getKey());
        }
        if (next != null) {
            Destination rest = next.getKey();
            context.timers().start(SCAN_PAUSE_NANOS, () -> scan(queues.ceilingEntry(rest)));
            return;
        }
        scans.remove();
        if (!scans.isEmpty()) {
            context.timers().start(SCAN_PAUSE_NANOS, () -> scan(queues.firstEntry()));
        }
    }
}
