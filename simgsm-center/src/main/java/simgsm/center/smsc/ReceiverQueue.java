package simgsm.center.smsc;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * Messages and reports that wait for one destination. Attempts begin in the order of acceptance, as many at a time as the
 * port's window allows. An entry that ends for any reason is removed at once, so {@link #size} counts what is held.
 */
final class ReceiverQueue {
    private final Destination destination;
    private final Instant startedAt;
    private final Timers timers;
    private final DeliveryPort port;
    private final BiConsumer<Entry, MessageState> ended;
    /** Entries without an attempt under way, by place. */
    private final NavigableMap<Long, Entry> ready;

    private int inFlight;
    private int reserved;
    private boolean isMemoryFull;
    private int failures;
    private int refusals;
    private Timer retry;
    private long nextPlace;

    /** An envelope in this queue. */
    final class Entry {
        private final Envelope envelope;
        private final long place = nextPlace++;
        private List<DeliveryAttempt> attempts = List.of();
        private int attemptCount;
        private Timer expiry;
        private boolean isInFlight;
        /** Final state if the attempt under way fails; null if another attempt follows. */
        private MessageState stateOnFailure;

        private Entry(Envelope envelope) {
            this.envelope = envelope;
        }

        Envelope envelope() {
            return envelope;
        }

        /** Removes the entry as DELETED; false if an attempt is under way. */
        boolean cancel() {
            if (!isInFlight) {
                remove(this, MessageState.DELETED);
            }
            return !isInFlight;
        }

        MessageHistory history() {
            WaitReason reason = waitReason(this);
            boolean isScheduled = reason == WaitReason.AWAITING_RETRY || reason == WaitReason.AWAITING_MEMORY;
            Optional<Instant> nextTry = isScheduled
                    ? Optional.ofNullable(retry).map(timer -> startedAt.plusNanos(timer.deadlineNanos()))
                    : Optional.empty();
            return new MessageHistory(
                    envelope.message(),
                    MessageState.ACCEPTED,
                    reason,
                    attempts,
                    attemptCount,
                    nextTry,
                    Optional.empty());
        }

        MessageHistory endedHistory(MessageState state) {
            return new MessageHistory(
                    envelope.message(),
                    state,
                    WaitReason.ENDED,
                    attempts,
                    attemptCount,
                    Optional.empty(),
                    Optional.of(now()));
        }

        private void attempted(DeliveryOutcome outcome) {
            attemptCount++;
            attempts = Stream.concat(
                            attempts.stream().skip(attempts.size() / MessageHistory.MAX_ATTEMPTS),
                            Stream.of(new DeliveryAttempt(now(), outcome)))
                    .toList();
        }
    }

    /**
     * @param startedAt the civil time at which {@code timers} stood at 0
     * @param ready an empty map
     * @param ended is called with each entry that leaves the queue and its final state
     */
    ReceiverQueue(
            Destination destination,
            Instant startedAt,
            Timers timers,
            DeliveryPort port,
            NavigableMap<Long, Entry> ready,
            BiConsumer<Entry, MessageState> ended) {
        this.destination = destination;
        this.startedAt = startedAt;
        this.timers = timers;
        this.port = port;
        this.ready = ready;
        this.ended = ended;
    }

    /** Entries held, those under way and the reserved places included. */
    int size() {
        return ready.size() + inFlight + reserved;
    }

    /** Reserves places for messages that are being stored; a negative count gives them back. */
    void reserve(int count) {
        reserved += count;
    }

    /** Adds an envelope; {@link #attempt} then begins its delivery. */
    Entry add(Envelope envelope) {
        Entry added = new Entry(envelope);
        ready.put(added.place, added);
        Duration lifetime = Duration.between(now(), envelope.expiresAt());
        added.expiry = timers.start(lifetime.toNanos(), () -> expire(added));
        return added;
    }

    /** The receiver has registered, or has memory again: the retry schedule begins anew. */
    void receiverAvailable() {
        failures = 0;
        refusals = 0;
        endPause();
        attempt();
    }

    private void endPause() {
        isMemoryFull = false;
        timers.cancel(retry);
        retry = null;
    }

    /** Begins as many attempts as can be made now. */
    void attempt() {
        while (retry == null
                && !ready.isEmpty()
                && inFlight < port.window(destination)
                && port.isReachable(destination)) {
            Entry first = ready.pollFirstEntry().getValue();
            first.isInFlight = true;
            inFlight++;
            port.deliver(first.envelope, ready.size() + inFlight > 1, outcome -> attempted(first, outcome));
        }
    }

    private void attempted(Entry entry, DeliveryOutcome outcome) {
        inFlight--;
        entry.isInFlight = false;
        entry.attempted(outcome);
        switch (outcome) {
            case DELIVERED -> answered(entry, MessageState.DELIVERED);
            case REFUSED -> answered(entry, MessageState.REJECTED);
            case MEMORY_FULL, BUSY, ABSENT, FAILED -> failed(entry, outcome);
        }
        attempt();
    }

    private void answered(Entry entry, MessageState state) {
        failures = 0;
        refusals = 0;
        remove(entry, state);
    }

    private void failed(Entry entry, DeliveryOutcome outcome) {
        if (entry.stateOnFailure == null) {
            ready.put(entry.place, entry);
        } else {
            remove(entry, entry.stateOnFailure);
        }
        if (retry == null && !ready.isEmpty()) {
            isMemoryFull = outcome == DeliveryOutcome.MEMORY_FULL;
            Duration pause = outcome == DeliveryOutcome.BUSY
                    ? RetrySchedule.pauseWhenBusy(++refusals)
                    : RetrySchedule.pauseAfter(++failures);
            retry = timers.start(pause.toNanos(), () -> {
                endPause();
                attempt();
            });
        }
    }

    private void expire(Entry entry) {
        if (entry.isInFlight) {
            entry.stateOnFailure = MessageState.EXPIRED;
        } else {
            remove(entry, MessageState.EXPIRED);
        }
    }

    private void remove(Entry entry, MessageState state) {
        ready.remove(entry.place);
        timers.cancel(entry.expiry);
        if (ready.isEmpty() && inFlight == 0) {
            endPause();
        }
        ended.accept(entry, state);
    }

    private WaitReason waitReason(Entry entry) {
        if (entry.isInFlight) {
            return WaitReason.UNDER_WAY;
        }
        if (inFlight > 0 || ready.firstKey() != entry.place) {
            return WaitReason.BEHIND_OTHERS;
        }
        if (isMemoryFull) {
            return WaitReason.AWAITING_MEMORY;
        }
        return retry == null ? WaitReason.AWAITING_RECEIVER : WaitReason.AWAITING_RETRY;
    }

    private Instant now() {
        return startedAt.plusNanos(timers.nowNanos());
    }
}
