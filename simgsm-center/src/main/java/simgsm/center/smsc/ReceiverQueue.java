package simgsm.center.smsc;

import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Queue;
import java.util.function.Function;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** What waits for one receiver; attempts begin in the order of acceptance, as many at a time as the way takes. */
final class ReceiverQueue {
    private final Recipient receiver;
    private final Instant startedAt;
    private final Timers timers;
    private final DeliveryPort port;
    private final Ends ends;
    private final Map<Long, Waiting> waiting = new LinkedHashMap<>();
    /** What is not being attempted. May hold envelopes that are gone. */
    private final Queue<Waiting> ready = new PriorityQueue<>(Comparator.comparingLong((Waiting each) -> each.place));

    private int inFlight;
    private boolean isMemoryFull;
    private int failures;
    private int refusals;
    private Timer retry;
    private long retryNanos;
    private long nextPlace;

    /** What the centre does when an envelope leaves the queue. */
    interface Ends {
        void ended(Envelope envelope, MessageState state, Attempts attempts);
    }

    private static final class Waiting {
        final long place;
        final Envelope envelope;
        final Attempts attempts = new Attempts();
        Timer expiry;
        boolean isInFlight;
        boolean isGone;
        /** How it ends if the attempt under way fails. */
        MessageState lateState;

        Waiting(long place, Envelope envelope) {
            this.place = place;
            this.envelope = envelope;
        }
    }

    /** @param startedAt the civil time at which {@code timers} stood at 0 */
    ReceiverQueue(Recipient receiver, Instant startedAt, Timers timers, DeliveryPort port, Ends ends) {
        this.receiver = receiver;
        this.startedAt = startedAt;
        this.timers = timers;
        this.port = port;
        this.ends = ends;
    }

    boolean isEmpty() {
        return waiting.isEmpty();
    }

    int size() {
        return waiting.size();
    }

    /** Adds the messages that wait here, until the list holds {@code most}. */
    void addMessagesTo(List<ShortMessage> found, int most) {
        addTo(found, most, each -> each.envelope.message());
    }

    /** Adds their histories, until the list holds {@code most}. */
    void addHistoriesTo(List<MessageHistory> found, int most) {
        skipGone();
        addTo(found, most, this::history);
    }

    private <T> void addTo(List<T> found, int most, Function<Waiting, T> view) {
        for (Waiting each : waiting.values()) {
            if (found.size() >= most) {
                return;
            }
            if (each.envelope instanceof Envelope.Delivery) {
                found.add(view.apply(each));
            }
        }
    }

    Optional<MessageHistory> history(long id) {
        skipGone();
        return find(id).map(this::history);
    }

    private Optional<Waiting> find(long id) {
        return waiting.values().stream()
                .filter(each -> each.envelope instanceof Envelope.Delivery
                        && each.envelope.message().id() == id)
                .findFirst();
    }

    private MessageHistory history(Waiting each) {
        Standing standing = standing(each);
        boolean isScheduled = standing == Standing.AWAITING_RETRY || standing == Standing.AWAITING_MEMORY;
        return new MessageHistory(
                each.envelope.message(),
                MessageState.ACCEPTED,
                standing,
                each.attempts.latest(),
                each.attempts.count(),
                isScheduled && retry != null ? Optional.of(startedAt.plusNanos(retryNanos)) : Optional.empty(),
                Optional.empty());
    }

    private Standing standing(Waiting each) {
        if (each.isInFlight) {
            return Standing.UNDER_WAY;
        }
        if (inFlight > 0 || each != ready.peek()) {
            return Standing.BEHIND_OTHERS;
        }
        if (isMemoryFull) {
            return Standing.AWAITING_MEMORY;
        }
        return retry == null ? Standing.AWAITING_RECEIVER : Standing.AWAITING_RETRY;
    }

    void add(Envelope envelope, long lifetimeNanos) {
        Waiting added = new Waiting(nextPlace++, envelope);
        waiting.put(added.place, added);
        ready.add(added);
        added.expiry = timers.start(lifetimeNanos, () -> expire(added));
        attempt();
    }

    /** The receiver has come, or has memory again: whatever stood against delivery is over. */
    void receiverAvailable() {
        isMemoryFull = false;
        failures = 0;
        refusals = 0;
        timers.cancel(retry);
        retry = null;
        attempt();
    }

    /** Begins as many attempts as can be made now. */
    void attempt() {
        while (!isMemoryFull && retry == null && inFlight < port.window(receiver) && skipGone() && isReachable()) {
            Waiting first = ready.remove();
            first.isInFlight = true;
            inFlight++;
            port.deliver(first.envelope, waiting.size() > 1, outcome -> ended(first, outcome));
        }
    }

    private boolean isReachable() {
        return port.isReachable(receiver);
    }

    /** @return whether anything is ready after that */
    private boolean skipGone() {
        while (!ready.isEmpty() && ready.peek().isGone) {
            ready.remove();
        }
        return !ready.isEmpty();
    }

    private void ended(Waiting attempted, DeliveryOutcome outcome) {
        inFlight--;
        attempted.isInFlight = false;
        attempted.attempts.add(new Attempt(startedAt.plusNanos(timers.nowNanos()), outcome));
        switch (outcome) {
            case DELIVERED -> remove(attempted, MessageState.DELIVERED);
            case REFUSED -> remove(attempted, MessageState.REJECTED);
            case MEMORY_FULL -> {
                isMemoryFull = true;
                failed(attempted, false);
            }
            case BUSY -> failed(attempted, true);
            case ABSENT, FAILED -> failed(attempted, false);
        }
        attempt();
    }

    private void remove(Waiting gone, MessageState state) {
        failures = 0;
        refusals = 0;
        gone.isGone = true;
        timers.cancel(gone.expiry);
        waiting.remove(gone.place);
        if (waiting.isEmpty()) {
            timers.cancel(retry);
            retry = null;
        }
        ends.ended(gone.envelope, state, gone.attempts);
    }

    private void failed(Waiting attempted, boolean isBusy) {
        if (attempted.lateState != null) {
            remove(attempted, attempted.lateState);
            return;
        }
        ready.add(attempted);
        if (retry != null) {
            return;
        }
        Duration pause = isBusy ? RetrySchedule.pauseWhenBusy(++refusals) : RetrySchedule.pauseAfter(++failures);
        retryNanos = timers.nowNanos() + pause.toNanos();
        retry = timers.start(pause.toNanos(), () -> {
            retry = null;
            isMemoryFull = false;
            attempt();
        });
    }

    private void expire(Waiting late) {
        end(late, MessageState.EXPIRED);
    }

    private void end(Waiting early, MessageState state) {
        early.lateState = state;
        if (!early.isInFlight) {
            remove(early, state);
        }
    }

    /** @return false if there is no such message here, or if it is just being delivered */
    boolean cancel(long id) {
        Optional<Waiting> found = find(id).filter(each -> !each.isInFlight);
        found.ifPresent(each -> end(each, MessageState.DELETED));
        return found.isPresent();
    }
}
