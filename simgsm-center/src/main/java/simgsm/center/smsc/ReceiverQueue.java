package simgsm.center.smsc;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import simgsm.timer.CivilTime;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * Messages and reports that wait for one destination. Attempts begin in the order of acceptance, as many at a time as
 * the port's window permits. After a failure the outcome determines if the whole queue pauses or the one entry is
 * postponed. An entry that ends for any reason is removed at once, so {@link #size} is exact.
 */
final class ReceiverQueue {
    /**
     * The context shared by all queues.
     *
     * @param held counts the octets of the entries
     * @param ended receives each entry that leaves its queue, and its final state
     */
    record Context(
            CivilTime civil,
            Timers timers,
            DeliveryPort port,
            ReceiverQueues.Containers containers,
            HeldOctets held,
            BiConsumer<QueueEntry, MessageState> ended) {}

    private final Destination destination;
    private final Context context;
    private final Timers timers;
    private final DeliveryPort port;
    /** Entries that may be tried now, by place. */
    private final NavigableMap<Long, QueueEntry> ready;
    /** Entries with an individual time of the next attempt. */
    private final NavigableMap<QueueEntry.Due, QueueEntry> postponed;

    private int scheduled;
    private int inFlight;
    private int reserved;
    private boolean isMemoryFull;
    private int failures;
    /** While it runs, the whole queue pauses. */
    private Timer pause;
    /** Runs until the first postponed entry is due. */
    private Timer next;

    private long availabilities;
    private long nextPlace;

    ReceiverQueue(Destination destination, Context context) {
        this.destination = destination;
        this.context = context;
        timers = context.timers;
        port = context.port;
        ready = context.containers.sorted();
        postponed = context.containers.sorted();
    }

    /** Number of entries, including active and reserved ones. */
    int size() {
        return ready.size() + postponed.size() + scheduled + inFlight + reserved;
    }

    /** Reserves places for messages being stored; a negative count returns them. */
    void reserve(int count) {
        reserved += count;
    }

    /** Adds an envelope; {@link #attempt} then begins its delivery. */
    QueueEntry add(Envelope envelope) {
        QueueEntry added = new QueueEntry(this, envelope, nextPlace++);
        begin(added);
        return added;
    }

    /** Makes an entry ready, now or at its scheduled time. */
    private void begin(QueueEntry entry) {
        Instant now = context.civil.now();
        entry.isScheduled = entry.envelope.notBefore().filter(now::isBefore).isPresent();
        if (entry.isScheduled) {
            scheduled++;
        } else {
            ready.put(entry.place, entry);
        }
        startTimer(entry);
    }

    /** Starts an entry's timer, again after a jump of the civil time that determines its end. */
    void startTimer(QueueEntry entry) {
        Optional<Instant> later = entry.envelope.notBefore().filter(time -> entry.isScheduled);
        Instant end = later.orElse(entry.envelope.expiresAt());
        timers.cancel(entry.timer);
        entry.timer = timers.start(Duration.between(context.civil.now(), end).toNanos(), () -> {
            if (entry.isScheduled) {
                scheduledTimeHasCome(entry);
            } else {
                expire(entry);
            }
        });
    }

    /** The entries that will be tried, without those scheduled, replaced or being tried. */
    Stream<QueueEntry> entries() {
        return Stream.concat(ready.values().stream(), postponed.values().stream());
    }

    private void scheduledTimeHasCome(QueueEntry entry) {
        unschedule(entry);
        begin(entry);
        attempt();
    }

    private void unschedule(QueueEntry entry) {
        entry.isScheduled = false;
        scheduled--;
    }

    /** Holds an entry during the storage of its replacement; false during an attempt. */
    boolean hold(QueueEntry entry) {
        if (entry.isInFlight) {
            return false;
        }
        takeOut(entry);
        entry.isInFlight = true;
        inFlight++;
        return true;
    }

    /** Returns a held entry to its place, with this content. */
    void release(QueueEntry entry, Envelope content) {
        inFlight--;
        entry.isInFlight = false;
        entry.stateOnFailure = null;
        entry.envelope = content;
        begin(entry);
        attempt();
    }

    /** Removes an entry as DELETED; false during an attempt. */
    boolean cancel(QueueEntry entry) {
        if (!entry.isInFlight) {
            remove(entry, MessageState.DELETED);
        }
        return !entry.isInFlight;
    }

    /** Restarts the retry schedule after the receiver has registered, or has memory again. */
    void receiverAvailable() {
        failures = 0;
        availabilities++;
        endPause();
        attempt();
    }

    private void endPause() {
        isMemoryFull = false;
        timers.cancel(pause);
        pause = null;
    }

    /** Begins as many attempts as possible. */
    void attempt() {
        while (pause == null && hasNext() && inFlight < port.window(destination) && port.isReachable(destination)) {
            QueueEntry first = pollNext();
            first.isInFlight = true;
            inFlight++;
            port.deliver(
                    first.envelope,
                    ready.size() + postponed.size() + inFlight > 1,
                    outcome -> attempted(first, outcome));
        }
        awaitNext();
    }

    private boolean hasNext() {
        return !ready.isEmpty() || hasDue();
    }

    private boolean hasDue() {
        return !postponed.isEmpty() && isDue(postponed.firstEntry().getKey());
    }

    private boolean isDue(QueueEntry.Due due) {
        return due.availability() < availabilities || due.nanos() <= timers.nowNanos();
    }

    private QueueEntry pollNext() {
        QueueEntry polled = (hasDue() ? postponed.pollFirstEntry() : ready.pollFirstEntry()).getValue();
        polled.due = null;
        return polled;
    }

    /** Schedules the first postponed entry; one that is already due is tried when there is space. */
    private void awaitNext() {
        Map.Entry<QueueEntry.Due, QueueEntry> first = postponed.isEmpty() ? null : postponed.firstEntry();
        boolean isAwaited = first != null && !isDue(first.getKey());
        if (next != null && isAwaited && next.deadlineNanos() == first.getKey().nanos()) {
            return;
        }
        timers.cancel(next);
        next = isAwaited ? timers.start(first.getKey().nanos() - timers.nowNanos(), this::attempt) : null;
    }

    private void attempted(QueueEntry entry, DeliveryOutcome outcome) {
        inFlight--;
        entry.isInFlight = false;
        context.held.attempted(entry.attempted(context.civil.now(), outcome));
        switch (outcome) {
            case DELIVERED -> answered(entry, MessageState.DELIVERED);
            case REFUSED -> answered(entry, MessageState.REJECTED);
            case MEMORY_FULL, ABSENT, FAILED -> pauseAfter(entry, outcome);
            case BUSY -> postpone(entry, RetrySchedule.pauseWhenBusy(++entry.refusals));
            case POSTPONED, UNANSWERED -> postpone(entry, RetrySchedule.pauseAfter(++entry.failures));
            case WITHDRAWN -> keep(entry);
        }
        attempt();
    }

    private void answered(QueueEntry entry, MessageState state) {
        failures = 0;
        remove(entry, state);
    }

    /** Keeps an entry after a failed attempt, if another one may follow. */
    private boolean keep(QueueEntry entry) {
        if (entry.stateOnFailure != null) {
            remove(entry, entry.stateOnFailure);
            return false;
        }
        ready.put(entry.place, entry);
        return true;
    }

    private void postpone(QueueEntry entry, Duration delay) {
        if (keep(entry)) {
            ready.remove(entry.place);
            entry.due = new QueueEntry.Due(availabilities, timers.nowNanos() + delay.toNanos(), entry.place);
            postponed.put(entry.due, entry);
        }
    }

    private void pauseAfter(QueueEntry entry, DeliveryOutcome outcome) {
        keep(entry);
        if (pause == null && !ready.isEmpty()) {
            isMemoryFull = outcome == DeliveryOutcome.MEMORY_FULL;
            pause = timers.start(RetrySchedule.pauseAfter(++failures).toNanos(), () -> {
                endPause();
                attempt();
            });
        }
    }

    private void expire(QueueEntry entry) {
        if (entry.isInFlight) {
            entry.stateOnFailure = MessageState.EXPIRED;
        } else {
            remove(entry, MessageState.EXPIRED);
        }
    }

    private void remove(QueueEntry entry, MessageState state) {
        takeOut(entry);
        if (ready.isEmpty() && inFlight == 0) {
            endPause();
        }
        context.ended.accept(entry, state);
    }

    private void takeOut(QueueEntry entry) {
        timers.cancel(entry.timer);
        if (entry.isScheduled) {
            unschedule(entry);
        } else if (entry.due == null) {
            ready.remove(entry.place);
        } else {
            postponed.remove(entry.due);
            entry.due = null;
            awaitNext();
        }
    }

    MessageHistory history(QueueEntry entry) {
        return new MessageHistory(
                entry.envelope.message(),
                MessageState.ACCEPTED,
                waitReason(entry),
                entry.attempts,
                entry.attemptCount,
                nextTryNanos(entry).map(context.civil::at),
                Optional.empty());
    }

    private Optional<Long> nextTryNanos(QueueEntry entry) {
        if (entry.isScheduled) {
            return Optional.of(entry.timer.deadlineNanos());
        }
        if (entry.due != null) {
            return isDue(entry.due) ? Optional.empty() : Optional.of(entry.due.nanos());
        }
        WaitReason reason = waitReason(entry);
        boolean isPaused = reason == WaitReason.AWAITING_RETRY || reason == WaitReason.AWAITING_MEMORY;
        return isPaused ? Optional.of(pause.deadlineNanos()) : Optional.empty();
    }

    private WaitReason waitReason(QueueEntry entry) {
        if (entry.isInFlight) {
            return WaitReason.UNDER_WAY;
        }
        if (entry.isScheduled) {
            return WaitReason.SCHEDULED;
        }
        if (entry.due != null) {
            return WaitReason.AWAITING_RETRY;
        }
        if (inFlight > 0 || ready.firstKey() != entry.place) {
            return WaitReason.BEHIND_OTHERS;
        }
        if (isMemoryFull) {
            return WaitReason.AWAITING_MEMORY;
        }
        return pause == null ? WaitReason.AWAITING_RECEIVER : WaitReason.AWAITING_RETRY;
    }
}
