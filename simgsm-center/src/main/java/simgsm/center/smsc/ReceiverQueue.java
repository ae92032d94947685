package simgsm.center.smsc;

import java.time.Duration;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Queue;
import simgsm.center.timer.Timer;
import simgsm.center.timer.Timers;

/** What waits for one receiver; attempts begin in the order of acceptance, as many at a time as the way takes. */
final class ReceiverQueue {
    /** When to try again after 1, 2, 3 ... failures; the last holds for all further ones. Minutes. */
    private static final int[] RETRY_MINUTES = {1, 5, 10, 30, 60, 180, 360, 720};

    private final Recipient receiver;
    private final Timers timers;
    private final DeliveryPort port;
    private final Ends ends;
    private final Map<Long, Waiting> waiting = new LinkedHashMap<>();
    /** What is not being attempted. May hold envelopes that are gone. */
    private final Queue<Waiting> ready = new PriorityQueue<>(Comparator.comparingLong((Waiting each) -> each.place));

    private int inFlight;
    private boolean isMemoryFull;
    private int failures;
    private Timer retry;
    private long nextPlace;

    /** What the centre does when an envelope leaves the queue. */
    interface Ends {
        void ended(Envelope envelope, MessageState state);
    }

    private static final class Waiting {
        final long place;
        final Envelope envelope;
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

    ReceiverQueue(Recipient receiver, Timers timers, DeliveryPort port, Ends ends) {
        this.receiver = receiver;
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
        for (Waiting each : waiting.values()) {
            if (found.size() >= most) {
                return;
            }
            if (each.envelope instanceof Envelope.Delivery delivery) {
                found.add(delivery.message());
            }
        }
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
        switch (outcome) {
            case DELIVERED -> remove(attempted, MessageState.DELIVERED);
            case REFUSED -> remove(attempted, MessageState.REJECTED);
            case MEMORY_FULL -> {
                isMemoryFull = true;
                failed(attempted);
            }
            case ABSENT, FAILED -> failed(attempted);
        }
        attempt();
    }

    private void remove(Waiting gone, MessageState state) {
        failures = 0;
        gone.isGone = true;
        timers.cancel(gone.expiry);
        waiting.remove(gone.place);
        if (waiting.isEmpty()) {
            timers.cancel(retry);
            retry = null;
        }
        ends.ended(gone.envelope, state);
    }

    private void failed(Waiting attempted) {
        if (attempted.lateState != null) {
            remove(attempted, attempted.lateState);
            return;
        }
        ready.add(attempted);
        if (retry != null) {
            return;
        }
        int minutes = RETRY_MINUTES[Math.min(failures++, RETRY_MINUTES.length - 1)];
        retry = timers.start(Duration.ofMinutes(minutes).toNanos(), () -> {
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
        for (Waiting each : waiting.values()) {
            if (each.envelope instanceof Envelope.Delivery delivery
                    && delivery.message().id() == id) {
                boolean canStill = !each.isInFlight;
                if (canStill) {
                    end(each, MessageState.DELETED);
                }
                return canStill;
            }
        }
        return false;
    }
}
