package simgsm.center.smsc;

import java.lang.System.Logger.Level;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RpCause;
import simgsm.octets.OctetString;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.timer.CivilTime;
import simgsm.timer.Timers;

/**
 * Accepts, stores and forwards short messages. A deterministic core on the exchange's thread and timers. The cost of
 * each method is independent of the number of waiting messages.
 */
public final class ShortMessageCenter {
    /** The centre's number, in RP addresses. */
    public static final Msisdn ADDRESS = new Msisdn("3003");

    /** Maximum of receipts for one application. */
    public static final int MAX_WAITING_RECEIPTS = 100_000;
    /** Pause before another attempt to store the end of a message. */
    private static final long STORE_AGAIN_NANOS = Duration.ofSeconds(5).toNanos();

    private static final System.Logger LOG = System.getLogger(ShortMessageCenter.class.getName());
    /** Validity of a message without a validity period, and of every report. */
    private static final Duration DEFAULT_VALIDITY = Duration.ofDays(7);

    private final CivilTime civil;
    private final Timers timers;
    private final MessageStore store;
    private final DeliveryPort port;
    private BiConsumer<ShortMessage, MessageState> listener;
    private final ReceiverQueues queues;
    private final MessageRegister messages;
    /** Receivers of the store's answers, by ticket: a sent report must not change, so its end is durable before. */
    private final Map<Long, Consumer<Boolean>> commits = new HashMap<>();

    private final RecentSubmissions recent = new RecentSubmissions();
    private final TimeStamps stamps = new TimeStamps();
    private final Admission admission;
    private long nextId = 1;
    private long nextTicket = 1;

    /** @param listener receives every change of state of every message */
    public ShortMessageCenter(
            CivilTime civil,
            Timers timers,
            MessageStore store,
            DeliveryPort port,
            BiConsumer<ShortMessage, MessageState> listener) {
        this(
                civil,
                timers,
                store,
                port,
                listener,
                ReceiverQueues.Containers.STANDARD,
                HeldOctets.in(Runtime.getRuntime().maxMemory()));
    }

    ShortMessageCenter(
            CivilTime civil,
            Timers timers,
            MessageStore store,
            DeliveryPort port,
            BiConsumer<ShortMessage, MessageState> listener,
            ReceiverQueues.Containers containers,
            HeldOctets held) {
        this.civil = civil;
        this.timers = timers;
        this.store = store;
        this.port = port;
        this.listener = listener;
        this.queues = new ReceiverQueues(new ReceiverQueue.Context(civil, timers, port, containers, held, this::ended));
        this.admission = new Admission(port, queues, held);
        this.messages = new MessageRegister(containers.inOrderOfInsertion());
    }

    /** Adds a listener to every change of state of every message. */
    public void addListener(BiConsumer<ShortMessage, MessageState> further) {
        listener = listener.andThen(further);
    }

    /** Restores the content of the store. Called once, before all other methods. */
    public void restore(StoredState stored) {
        nextId = stored.lastId() + 1;
        recent.restore(stored.recent(), now(), timers.nowNanos());
        stamps.restore(stored.recent());
        stored.waiting().forEach(message -> enqueue(new Envelope.Delivery(message)));
        for (StoredState.Unreported each : stored.unreported()) {
            report(reportOf(each.message(), each.ended().state(), each.ended().at()));
        }
    }

    /**
     * Accepts a message from a mobile.
     *
     * @param submit a SUBMIT
     * @param isRepeated true if it may repeat an accepted message although TP-RD is not set
     * @param answer called once: empty when the message is stored, else the cause of its refusal
     */
    public void submit(Msisdn from, OctetString submit, boolean isRepeated, Consumer<Optional<RpCause>> answer) {
        ShortMessage message;
        try {
            message = TransferUnits.accept(nextId, from, submit, now(), DEFAULT_VALIDITY, port::called);
        } catch (ProtocolViolation violation) {
            answer.accept(Optional.of(RpCause.ofCode(violation.statusCause().code())));
            return;
        }
        SubmitTpdu unit = TransferUnits.submitOf(message);
        Optional<Long> original = isRepeated || unit.rejectDuplicates()
                ? recent.original(from, message.to(), unit, timers.nowNanos())
                : Optional.empty();
        Optional<RpCause> refusal = original.isPresent() ? Optional.empty() : admission.refusal(message.to(), 1);
        if (original.isPresent()) {
            answerAs(original.get(), answer);
        } else if (refusal.isPresent()) {
            answer.accept(refusal);
        } else {
            recent.remember(from, message.to(), unit, nextTicket, timers.nowNanos());
            Instant stamp = stamps.stamp(message.sender(), message.to(), unit, now());
            accept(List.of(message.stampedAt(stamp)), answer);
        }
    }

    /** The id of the next accepted message; the parts of a message have consecutive ids. */
    public long nextId() {
        return nextId;
    }

    /**
     * Accepts messages from an application, all or none: the parts of one text for each of its receivers. Their ids
     * begin with {@link #nextId}. A receipt is sent for the last part to each receiver.
     *
     * @param units with the receivers' numbers as destinations, grouped by receiver
     * @param answer called once: empty when all are stored, else the cause of their refusal
     */
    public void submit(
            EsmeOrigin origin,
            Msisdn from,
            List<SubmitTpdu> units,
            Optional<Instant> expiresAt,
            Consumer<Optional<RpCause>> answer) {
        List<ShortMessage> accepted = new ArrayList<>(units.size());
        for (SubmitTpdu unit : units) {
            Msisdn to = port.called(unit.destination().number().orElseThrow());
            Optional<RpCause> refusal = admission.refusal(to, units.size());
            if (refusal.isPresent()) {
                answer.accept(refusal);
                return;
            }
            int before = accepted.size();
            int after = units.size() - before - 1;
            boolean isLastPart =
                    after == 0 || !units.get(before + 1).destination().equals(unit.destination());
            accepted.add(new ShortMessage(
                    nextId + before,
                    from,
                    to,
                    TpduCodec.encode(unit),
                    stamps.stamp(origin.source(), to, unit, now()),
                    expiresAt.orElse(origin.deliverAt().orElse(now()).plus(DEFAULT_VALIDITY)),
                    Optional.of(origin.member(new EsmeOrigin.Group(before, after), isLastPart))));
        }
        accept(accepted, answer);
    }

    /** Answers a repeated submission like the original: at once if that is stored, else together with it. */
    private void answerAs(long ticket, Consumer<Optional<RpCause>> answer) {
        Consumer<Boolean> original = commits.get(ticket);
        if (original == null) {
            answer.accept(Optional.empty());
        } else {
            commits.put(ticket, original.andThen(isDurable -> answer.accept(answerOf(isDurable))));
        }
    }

    private static Optional<RpCause> answerOf(boolean isDurable) {
        return isDurable ? Optional.empty() : Optional.of(RpCause.NETWORK_OUT_OF_ORDER);
    }

    private void accept(List<ShortMessage> accepted, Consumer<Optional<RpCause>> answer) {
        nextId += accepted.size();
        admission.storing(accepted);
        commit(
                accepted.stream().<StoreEntry>map(StoreEntry.Accepted::new).toList(),
                isDurable -> stored(accepted, isDurable, answer));
    }

    /** The reason to refuse this number of messages to a receiver; empty if they can be accepted. */
    public Optional<RpCause> refusal(Msisdn receiver, int count) {
        return admission.refusal(receiver, count);
    }

    /** True if the number is a subscriber's, attached or not. */
    public boolean isSubscriber(Msisdn number) {
        return port.isSubscriber(number);
    }

    /** The store's answer to an earlier commit. */
    public void committed(long ticket, boolean isDurable) {
        Consumer<Boolean> receiver = commits.remove(ticket);
        if (receiver != null) {
            receiver.accept(isDurable);
        }
    }

    private void stored(List<ShortMessage> accepted, boolean isDurable, Consumer<Optional<RpCause>> answer) {
        admission.stored(accepted);
        if (isDurable) {
            answer.accept(answerOf(true));
            for (ShortMessage message : accepted) {
                listener.accept(message, MessageState.ACCEPTED);
                enqueue(new Envelope.Delivery(message));
            }
        } else {
            for (ShortMessage message : accepted) {
                queues.removeIfEmpty(new Destination.Number(message.to()));
                if (message.esme().isEmpty()) {
                    recent.forget(message.from(), message.to(), TransferUnits.submitOf(message));
                }
            }
            answer.accept(answerOf(false));
            accepted.forEach(message -> listener.accept(message, MessageState.REJECTED));
        }
    }

    /**
     * Replaces the content of a waiting message; it keeps its place.
     *
     * @param changed with the message's id and receiver
     * @param answer receives true if the new content is stored; otherwise the old one remains. Not called after a
     * result of false
     * @return false if no message with this id waits, or an attempt at it is active
     */
    public boolean replace(ShortMessage changed, Consumer<Boolean> answer) {
        QueueEntry entry = messages.entry(changed.id());
        if (entry == null || !entry.queue.hold(entry)) {
            return false;
        }
        commit(new StoreEntry.Accepted(changed), isDurable -> {
            answer.accept(isDurable);
            if (isDurable) {
                admission.replaced(entry.envelope.message(), changed);
            }
            entry.queue.release(entry, isDurable ? new Envelope.Delivery(changed) : entry.envelope);
        });
        return true;
    }

    /** Handles a mobile's registration, or its free memory. */
    public void available(Msisdn receiver) {
        available(new Destination.Number(receiver));
    }

    /** Handles a receiver's availability. */
    public void available(Destination destination) {
        queues.available(destination);
    }

    /** Handles the availability of all destinations of a kind; they are tried in portions, within a second. */
    public void available(Predicate<Destination> destinations) {
        queues.available(destinations);
    }

    /** Uses new space on the route to a destination. */
    public void roomFor(Destination destination) {
        queues.roomFor(destination);
    }

    /**
     * Removes a waiting message.
     *
     * @return false if no message with this id waits, or an attempt at it is active
     */
    public boolean cancel(long id) {
        QueueEntry entry = messages.entry(id);
        return entry != null && entry.queue.cancel(entry);
    }

    /** The waiting messages, and the last ended ones. */
    public MessageRegister messages() {
        return messages;
    }

    /** Number of waiting messages and reports. */
    public int waitingCount() {
        return admission.waiting();
    }

    private void enqueue(Envelope envelope) {
        admission.queued(envelope);
        ReceiverQueue queue = queues.of(envelope.destination());
        QueueEntry entry = queue.add(envelope);
        if (envelope instanceof Envelope.Delivery) {
            messages.add(entry);
        }
        queue.attempt();
    }

    private void ended(QueueEntry entry, MessageState state) {
        admission.left(entry);
        queues.removeIfEmpty(entry.envelope.destination());
        ShortMessage message = entry.envelope.message();
        if (entry.envelope instanceof Envelope.Delivery) {
            messages.ended(entry, state, now());
            deliveryEnded(message, state);
        } else {
            reported(message);
        }
    }

    private void deliveryEnded(ShortMessage message, MessageState state) {
        if (TransferUnits.wantsReport(message, state)) {
            storeEnd(reportOf(message, state, now()));
        } else {
            store(new StoreEntry.Ended(message.id(), state, now(), false));
        }
        listener.accept(message, state);
    }

    private void storeEnd(Envelope.Report report) {
        commit(new StoreEntry.Ended(report.message().id(), report.state(), report.at(), true), isDurable -> {
            if (isDurable) {
                report(report);
            } else {
                // after a crash its message would wait again, and might end in another state
                timers.start(STORE_AGAIN_NANOS, () -> storeEnd(report));
            }
        });
    }

    /**
     * Stores an entry.
     *
     * @param stored receives, once, true if it is durable
     */
    public void commit(StoreEntry entry, Consumer<Boolean> stored) {
        commit(List.of(entry), stored);
    }

    private void commit(List<StoreEntry> entries, Consumer<Boolean> stored) {
        long ticket = nextTicket++;
        commits.put(ticket, stored);
        store.commit(ticket, entries);
    }

    private static Envelope.Report reportOf(ShortMessage message, MessageState state, Instant at) {
        return new Envelope.Report(message, state, at, at.plus(DEFAULT_VALIDITY));
    }

    /**
     * Queues a report; drops receipts above {@link #MAX_WAITING_RECEIPTS} of an application that does not fetch them.
     */
    private void report(Envelope.Report report) {
        int waiting = queues.size(report.destination());
        if (report.destination() instanceof Destination.Number || waiting < MAX_WAITING_RECEIPTS) {
            enqueue(report);
        } else {
            LOG.log(Level.DEBUG, "{0}: {1} receipts wait, one more is dropped", report.destination(), waiting);
            reported(report.message());
        }
    }

    private void reported(ShortMessage message) {
        store(new StoreEntry.Reported(message.id()));
    }

    private void store(StoreEntry entry) {
        store.commit(MessageStore.NO_TICKET, List.of(entry));
    }

    /** Recomputes beginnings and ends after a jump of the civil time. */
    public void timeHasJumped() {
        Stream.concat(messages.entries(Integer.MAX_VALUE), queues.entries())
                .distinct()
                .toList()
                .forEach(entry -> entry.queue.startTimer(entry));
    }

    /** Civil time. */
    public Instant now() {
        return civil.now();
    }
}
