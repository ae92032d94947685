package simgsm.center.smsc;

import java.lang.System.Logger.Level;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RpCause;
import simgsm.octets.OctetString;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.timer.Timers;

/** Accepts, stores and forwards short messages. A deterministic core on the exchange's thread and timers. */
public final class ShortMessageCenter {
    /** The centre's own number, in RP addresses. */
    public static final Msisdn ADDRESS = new Msisdn("3003");

    public static final int MAX_WAITING_PER_RECEIVER = 200_000;
    public static final int MAX_WAITING = 500_000;
    /** Receipts for one application. */
    public static final int MAX_WAITING_RECEIPTS = 100_000;
    /** So many submissions may wait for the store; a disk that is slower is congested. */
    static final int MAX_UNCOMMITTED = 50_000;

    /** When to ask a store again that has failed. */
    private static final long STORE_AGAIN_NANOS = Duration.ofSeconds(5).toNanos();

    private static final System.Logger LOG = System.getLogger(ShortMessageCenter.class.getName());

    /** How long a message without a validity period is kept, and every report. */
    private static final Duration DEFAULT_VALIDITY = Duration.ofDays(7);

    private final Instant startedAt;
    private final Timers timers;
    private final MessageStore store;
    private final DeliveryPort port;
    private final MessageListener listener;
    private final Map<Recipient, ReceiverQueue> queues = new LinkedHashMap<>();
    private final Map<Long, Submission> submissions = new HashMap<>();
    /** Reports whose messages' ends are not yet durable: a report that has once been sent never changes. */
    private final Map<Long, Envelope.Report> reports = new HashMap<>();

    private final RecentSubmissions recent = new RecentSubmissions();
    private final TimeStamps stamps = new TimeStamps();
    private final EndedMessages endedMessages = new EndedMessages();
    private int waitingCount;
    private long nextId = 1;
    private long nextTicket = 1;

    private record Submission(ShortMessage message, Consumer<Optional<RpCause>> answer) {}

    /** @param startedAt the civil time at which {@code timers} stood at 0 */
    public ShortMessageCenter(
            Instant startedAt, Timers timers, MessageStore store, DeliveryPort port, MessageListener listener) {
        this.startedAt = startedAt;
        this.timers = timers;
        this.store = store;
        this.port = port;
        this.listener = listener;
    }

    /** Goes on where an earlier life of this centre ended. To be called once, before anything else. */
    public void restore(Restored restored) {
        nextId = restored.lastId() + 1;
        recent.restore(restored.recent(), now(), timers.nowNanos());
        stamps.restore(restored.recent());
        restored.waiting().forEach(message -> enqueue(new Envelope.Delivery(message)));
        for (Restored.Unreported each : restored.unreported()) {
            report(reportOf(each.message(), each.ended().state(), each.ended().at()));
        }
    }

    /**
     * Takes a message from a sender.
     *
     * @param submit a SUBMIT
     * @param answer told once: empty when the message is stored, else the reason for which it is refused
     */
    public void submit(Msisdn from, OctetString submit, Consumer<Optional<RpCause>> answer) {
        submit(from, submit, false, answer);
    }

    /** @param isRepeated whether it may be one that was taken already, even if it does not say so (TP-RD) */
    public void submit(Msisdn from, OctetString submit, boolean isRepeated, Consumer<Optional<RpCause>> answer) {
        ShortMessage message;
        try {
            message = TransferUnits.accept(nextId, from, submit, now(), DEFAULT_VALIDITY);
        } catch (ProtocolViolation violation) {
            answer.accept(Optional.of(RpCause.ofCode(violation.statusCause().code())));
            return;
        }
        SubmitTpdu unit = TransferUnits.submitOf(message);
        Optional<Long> original = isRepeated || unit.rejectDuplicates()
                ? recent.original(from, message.to(), unit, timers.nowNanos())
                : Optional.empty();
        if (original.isPresent()) {
            answerAs(original.get(), answer);
        } else if (!port.isServed(message.to())) {
            answer.accept(Optional.of(RpCause.UNASSIGNED_NUMBER));
        } else if (hasRoomFor(message.to())) {
            recent.remember(from, message.to(), unit, nextTicket, timers.nowNanos());
            commit(message.stampedAt(stamps.stamp(message.sender(), message.to(), unit, now())), answer);
        } else {
            answer.accept(Optional.of(RpCause.CONGESTION));
        }
    }

    /** The id of the message that is taken next. */
    public long nextId() {
        return nextId;
    }

    /** Takes a message from an application, under {@link #nextId}. */
    public void submit(
            EsmeOrigin origin,
            Msisdn from,
            Msisdn to,
            SubmitTpdu submit,
            Optional<Instant> expiresAt,
            Consumer<Optional<RpCause>> answer) {
        if (!port.isServed(to)) {
            answer.accept(Optional.of(RpCause.UNASSIGNED_NUMBER));
        } else if (hasRoomFor(to)) {
            Instant now = now();
            commit(
                    new ShortMessage(
                            nextId,
                            from,
                            to,
                            TpduCodec.encode(submit),
                            stamps.stamp(origin.source(), to, submit, now),
                            expiresAt.orElse(now.plus(DEFAULT_VALIDITY)),
                            Optional.of(origin)),
                    answer);
        } else {
            answer.accept(Optional.of(RpCause.CONGESTION));
        }
    }

    /** A repeated submission: stored already, or answered together with the first one. */
    private void answerAs(long ticket, Consumer<Optional<RpCause>> answer) {
        Submission pending = submissions.get(ticket);
        if (pending == null) {
            answer.accept(Optional.empty());
        } else {
            submissions.put(ticket, new Submission(pending.message, pending.answer.andThen(answer)));
        }
    }

    private void commit(ShortMessage message, Consumer<Optional<RpCause>> answer) {
        nextId++;
        long ticket = nextTicket++;
        submissions.put(ticket, new Submission(message, answer));
        store.commit(ticket, new StoreEntry.Accepted(message));
    }

    private boolean hasRoomFor(Msisdn receiver) {
        ReceiverQueue queue = queues.get(new Recipient.Number(receiver));
        return submissions.size() < MAX_UNCOMMITTED
                && waitingCount + submissions.size() < MAX_WAITING
                && (queue == null || queue.size() < MAX_WAITING_PER_RECEIVER);
    }

    /** The store's answer to an earlier commit. */
    public void committed(long ticket, boolean isDurable) {
        Submission submission = submissions.remove(ticket);
        Envelope.Report report = reports.remove(ticket);
        if (report != null) {
            endStored(report, isDurable);
        } else if (submission != null) {
            answer(submission, isDurable);
        }
    }

    private void answer(Submission submission, boolean isDurable) {
        if (isDurable) {
            submission.answer.accept(Optional.empty());
            listener.changed(submission.message, MessageState.ACCEPTED);
            enqueue(new Envelope.Delivery(submission.message));
        } else {
            ShortMessage lost = submission.message;
            if (lost.esme().isEmpty()) {
                recent.forget(lost.from(), lost.to(), TransferUnits.submitOf(lost));
            }
            submission.answer.accept(Optional.of(RpCause.NETWORK_OUT_OF_ORDER));
            listener.changed(submission.message, MessageState.REJECTED);
        }
    }

    /** A receiver has registered, or has memory for messages again. */
    public void available(Msisdn receiver) {
        available(new Recipient.Number(receiver));
    }

    /** The same for any receiver. */
    public void available(Recipient receiver) {
        ReceiverQueue queue = queues.get(receiver);
        if (queue != null) {
            queue.receiverAvailable();
        }
    }

    /** All receivers of a kind have become available, as when an application comes that serves them. */
    public void available(Predicate<Recipient> receivers) {
        List<Recipient> found = queues.keySet().stream().filter(receivers).toList();
        found.forEach(this::available);
    }

    /** There is room again on the way to a receiver; nothing else has changed. */
    public void roomFor(Recipient receiver) {
        ReceiverQueue queue = queues.get(receiver);
        if (queue != null) {
            queue.attempt();
        }
    }

    /**
     * Takes a message back that waits and is not just being delivered.
     *
     * @return whether it was so
     */
    public boolean cancel(Msisdn receiver, long id) {
        ReceiverQueue queue = queues.get(new Recipient.Number(receiver));
        return queue != null && queue.cancel(id);
    }

    /** Messages that wait, by receiver and in order; reports are not among them. */
    public List<ShortMessage> waiting() {
        return waiting(Integer.MAX_VALUE);
    }

    /** The same, but no more than the first so many. */
    public List<ShortMessage> waiting(int most) {
        List<ShortMessage> found = new ArrayList<>();
        for (ReceiverQueue queue : queues.values()) {
            queue.addMessagesTo(found, most);
        }
        return found;
    }

    /** What has happened to the messages that wait, by receiver and in order, no more than so many. */
    public List<MessageHistory> waitingHistories(int most) {
        List<MessageHistory> found = new ArrayList<>();
        for (ReceiverQueue queue : queues.values()) {
            queue.addHistoriesTo(found, most);
        }
        return found;
    }

    /** What has happened to those that have ended lately, the newest first, no more than so many. */
    public List<MessageHistory> endedHistories(int most) {
        return endedMessages.newest(most);
    }

    /** What has happened to this message; empty if it is not known, or has ended too long ago. */
    public Optional<MessageHistory> history(long id) {
        return queues.values().stream()
                .map(queue -> queue.history(id))
                .flatMap(Optional::stream)
                .findFirst()
                .or(() -> endedMessages.find(id));
    }

    /** Messages and reports that wait. */
    public int waitingCount() {
        return waitingCount;
    }

    private void enqueue(Envelope envelope) {
        waitingCount++;
        Duration lifetime = Duration.between(now(), envelope.expiresAt());
        queues.computeIfAbsent(
                        envelope.receiver(),
                        receiver -> new ReceiverQueue(receiver, startedAt, timers, port, this::ended))
                .add(envelope, lifetime.toNanos());
    }

    private void ended(Envelope envelope, MessageState state, Attempts attempts) {
        waitingCount--;
        if (queues.get(envelope.receiver()).isEmpty()) {
            queues.remove(envelope.receiver());
        }
        if (envelope instanceof Envelope.Delivery) {
            endedMessages.add(new MessageHistory(
                    envelope.message(),
                    state,
                    Standing.ENDED,
                    attempts.latest(),
                    attempts.count(),
                    Optional.empty(),
                    Optional.of(now())));
            deliveryEnded(envelope.message(), state);
        } else {
            reported(envelope.message());
        }
    }

    private void deliveryEnded(ShortMessage message, MessageState state) {
        boolean reportFollows = TransferUnits.wantsReport(message, state);
        if (reportFollows) {
            storeEnd(reportOf(message, state, now()));
        } else {
            store.commit(MessageStore.NO_TICKET, new StoreEntry.Ended(message.id(), state, now(), false));
        }
        listener.changed(message, state);
    }

    private void storeEnd(Envelope.Report report) {
        long ticket = nextTicket++;
        reports.put(ticket, report);
        store.commit(ticket, new StoreEntry.Ended(report.message().id(), report.state(), report.at(), true));
    }

    /** After a crash the message of an end that was not stored waits again, and may end in another way. */
    private void endStored(Envelope.Report report, boolean isDurable) {
        if (isDurable) {
            report(report);
        } else {
            timers.start(STORE_AGAIN_NANOS, () -> storeEnd(report));
        }
    }

    private static Envelope.Report reportOf(ShortMessage message, MessageState state, Instant at) {
        return new Envelope.Report(message, state, at, at.plus(DEFAULT_VALIDITY));
    }

    /** Reports for somebody who never fetches them must not take the room of messages. */
    private void report(Envelope.Report report) {
        ReceiverQueue queue = queues.get(report.receiver());
        if (report.receiver() instanceof Recipient.Number || queue == null || queue.size() < MAX_WAITING_RECEIPTS) {
            enqueue(report);
        } else {
            LOG.log(Level.DEBUG, "{0}: fetches no receipts, one more is lost", report.receiver());
            reported(report.message());
        }
    }

    private void reported(ShortMessage message) {
        store.commit(MessageStore.NO_TICKET, new StoreEntry.Reported(message.id()));
    }

    /** Civil time. */
    public Instant now() {
        return startedAt.plusNanos(timers.nowNanos());
    }
}
