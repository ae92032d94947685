package simgsm.center.smsc;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simgsm.air.Msisdn;
import simgsm.center.timer.Timer;
import simgsm.center.timer.Timers;

/** What waits for one receiver, in the order of acceptance; one attempt at a time. */
final class ReceiverQueue {
    /** When to try again after 1, 2, 3 ... failures; the last holds for all further ones. Minutes. */
    private static final int[] RETRY_MINUTES = {1, 5, 10, 30, 60, 180, 360, 720};

    private final Msisdn receiver;
    private final Timers timers;
    private final DeliveryPort port;
    private final Ends ends;
    private final Map<Long, Waiting> waiting = new LinkedHashMap<>();
    private Waiting inFlight;
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
        boolean isExpired;

        Waiting(long place, Envelope envelope) {
            this.place = place;
            this.envelope = envelope;
        }
    }

    ReceiverQueue(Msisdn receiver, Timers timers, DeliveryPort port, Ends ends) {
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

    private void attempt() {
        boolean mustWait = inFlight != null || isMemoryFull || retry != null || waiting.isEmpty();
        if (mustWait || !port.isReachable(receiver)) {
            return;
        }
        Waiting first = waiting.values().iterator().next();
        inFlight = first;
        port.deliver(receiver, first.envelope.tpdu(waiting.size() > 1), outcome -> ended(first, outcome));
    }

    private void ended(Waiting attempted, DeliveryOutcome outcome) {
        inFlight = null;
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
        timers.cancel(gone.expiry);
        waiting.remove(gone.place);
        ends.ended(gone.envelope, state);
    }

    private void failed(Waiting attempted) {
        if (attempted.isExpired) {
            remove(attempted, MessageState.EXPIRED);
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
        late.isExpired = true;
        if (late != inFlight) {
            remove(late, MessageState.EXPIRED);
        }
    }
}
