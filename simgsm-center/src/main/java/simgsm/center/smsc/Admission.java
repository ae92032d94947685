package simgsm.center.smsc;

import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;

/** Decides on the acceptance of messages: counts those being stored or waiting, and their heap. */
final class Admission {
    static final int MAX_WAITING_PER_RECEIVER = 200_000;
    /** Maximum in total; a heap below 2 GB sets a lower limit: {@link HeldOctets}. */
    static final int MAX_WAITING = 1_000_000;
    /** Messages passed to the store but not yet durable; above it, submissions are refused with congestion. */
    static final int MAX_UNCOMMITTED = 50_000;

    private static final System.Logger LOG = System.getLogger(Admission.class.getName());

    private final DeliveryPort port;
    private final ReceiverQueues queues;
    private final HeldOctets held;
    private int waiting;
    private int uncommitted;

    Admission(DeliveryPort port, ReceiverQueues queues, HeldOctets held) {
        this.port = port;
        this.queues = queues;
        this.held = held;
    }

    /** The reason to refuse this number of messages to a receiver; empty if they can be accepted. */
    Optional<RpCause> refusal(Msisdn receiver, int count) {
        if (!port.isServed(receiver)) {
            return Optional.of(RpCause.UNASSIGNED_NUMBER);
        }
        boolean hasRoom = uncommitted + count <= MAX_UNCOMMITTED
                && waiting + uncommitted + count <= MAX_WAITING
                && queues.size(new Destination.Number(receiver)) + count <= MAX_WAITING_PER_RECEIVER
                && held.hasRoomFor((long) count * HeldOctets.ENVELOPE);
        return hasRoom ? Optional.empty() : congestion(receiver);
    }

    private Optional<RpCause> congestion(Msisdn receiver) {
        if (held.isNewlyRefusing()) {
            LOG.log(
                    Level.WARNING,
                    "short messages are refused: {0} wait, {1} of them for {2}; they hold {3} MB of the heap, {4} MB are the"
                            + " limit (-Xmx sets the heap)",
                    waiting + uncommitted,
                    queues.size(new Destination.Number(receiver)),
                    receiver.digits(),
                    held.held() >> 20,
                    held.most() >> 20);
        }
        return Optional.of(RpCause.CONGESTION);
    }

    /** Counts messages passed to the store. */
    void storing(List<ShortMessage> messages) {
        uncommitted += messages.size();
        messages.forEach(held::add);
        reserve(messages, 1);
    }

    /** Handles the store's answer. */
    void stored(List<ShortMessage> messages) {
        uncommitted -= messages.size();
        messages.forEach(held::remove);
        reserve(messages, -1);
    }

    private void reserve(List<ShortMessage> messages, int countEach) {
        messages.forEach(
                message -> queues.of(new Destination.Number(message.to())).reserve(countEach));
    }

    void queued(Envelope envelope) {
        waiting++;
        held.add(envelope.message());
    }

    /** Handles an entry's removal from its queue. */
    void left(QueueEntry entry) {
        waiting--;
        held.remove(entry.envelope.message());
        held.attempted(-entry.attempts.size());
    }

    void replaced(ShortMessage old, ShortMessage changed) {
        held.remove(old);
        held.add(changed);
    }

    /** Number of waiting messages and reports. */
    int waiting() {
        return waiting;
    }
}
