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

/** The queues of all destinations that something waits for. */
final class ReceiverQueues {
    /** Makes the collections that grow with the number of messages; a test counts the accesses to them. */
    interface Containers {
        Containers STANDARD = new Containers() {};

        default <K, V> Map<K, V> inOrderOfInsertion() {
            return new LinkedHashMap<>();
        }

        default <K, V> NavigableMap<K, V> sorted() {
            return new TreeMap<>();
        }
    }

    /** Destinations that {@link #available(Predicate)} looks at in one go, and the pause before the next ones. */
    static final int SCANNED_AT_ONCE = 1_000;

    private static final long SCAN_PAUSE_NANOS = Duration.ofMillis(1).toNanos();

    private final ReceiverQueue.Context context;
    private final NavigableMap<Destination, ReceiverQueue> queues;
    private final Deque<Predicate<Destination>> scans = new ArrayDeque<>();

    ReceiverQueues(ReceiverQueue.Context context) {
        this.context = context;
        queues = context.containers().sorted();
    }

    /** Messages and reports held for a destination, reserved places included. */
    int size(Destination destination) {
        ReceiverQueue queue = queues.get(destination);
        return queue == null ? 0 : queue.size();
    }

    /** The queue of a destination, made if there is none. */
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

    /** The entries of all queues that are tried by and by. */
    Stream<QueueEntry> entries() {
        return queues.values().stream().flatMap(ReceiverQueue::entries);
    }

    /** A receiver has become available. */
    void available(Destination destination) {
        ReceiverQueue queue = queues.get(destination);
        if (queue != null) {
            queue.receiverAvailable();
        }
    }

    /** There is room again on the way to a destination; nothing else has changed. */
    void roomFor(Destination destination) {
        ReceiverQueue queue = queues.get(destination);
        if (queue != null) {
            queue.attempt();
        }
    }

    /**
     * All destinations of a kind have become available. The first {@link #SCANNED_AT_ONCE} are looked at now, the same
     * number every further millisecond.
     */
    void available(Predicate<Destination> destinations) {
        scans.add(destinations);
        if (scans.size() == 1) {
            scan(queues.firstEntry());
        }
    }

    /** Looks at the queues from this entry on for the oldest scan. */
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
