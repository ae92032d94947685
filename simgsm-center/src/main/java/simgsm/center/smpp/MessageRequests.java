package simgsm.center.smpp;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.center.smpp.EsmeSettings.EsmeAlphabet;
import simgsm.center.smpp.MessageStatusStore.MessageStatus;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.EsmeOrigin.Receipts;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppTime;
import simgsm.smpp.SmppViolation;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.timer.Timers;

/** Fulfils the requests that submit, query, cancel and replace messages. */
final class MessageRequests {
    /** Maximum of parts times receivers of one submission. */
    static final int MAX_MESSAGES = 1_000;
    /** Maximum time until delivery. */
    static final Duration MAX_SCHEDULE = Duration.ofDays(366);

    /** TP-MR and the reference of concatenated parts are one octet. */
    private static final int REFERENCES = 256;
    /** Pause after {@link #MAX_MESSAGES} cancellations of one request. */
    private static final long CANCEL_PAUSE_NANOS = Duration.ofMillis(1).toNanos();

    private static final int RECEIPT_BITS = 0x03;
    /** Bits of registered_delivery (5.2.17): receipts, and an intermediate notification if there is one. */
    private static final int REGISTERED_DELIVERY_BITS = 0x13;

    /** Bits of esm_class (5.2.12). */
    private static final int MODE_BITS = 0x03;
    /** Messaging mode "forward": the response waits for the delivery. */
    private static final int FORWARD_MODE = 0x02;
    /** Message types that are not served; 0x08, a delivery acknowledgement, is the default of rusmpp 0.4 and a text like others. */
    private static final int TYPE_BITS = 0x34;

    /**
     * The requesting application.
     *
     * @param ownNumber replaces an empty source address
     * @param permits true if it may send as a number or name
     */
    record Requester(String systemId, Msisdn ownNumber, Optional<EsmeAlphabet> alphabet, Predicate<String> permits) {}

    private final ShortMessageCenter center;
    private final Timers timers;
    private final MessageStatusStore statuses = new MessageStatusStore();

    MessageRequests(ShortMessageCenter center, Timers timers) {
        this.center = center;
        this.timers = timers;
        center.addListener((message, state) -> statuses.changed(message, state, center.now()));
    }

    /**
     * Fulfils a request.
     *
     * @param answer receives the response, once, now or when the request is stored
     * @throws SmppViolation if the request is refused; nothing is answered then
     */
    void fulfil(Requester by, SmppPdu request, Consumer<SmppPdu> answer) throws SmppViolation {
        if (request instanceof SmppPdu.Message message) {
            List<SmppAddress> destination = List.of(message.message().destination());
            submit(
                    by,
                    message.message(),
                    destination,
                    submitted -> new SmppPdu.MessageResponse(
                            message.command(), submitted.status, message.sequence(), submitted.id),
                    answer);
        } else if (request instanceof SmppPdu.SubmitMulti multi) {
            submit(
                    by,
                    multi.message(),
                    multi.destinations(),
                    submitted -> new SmppPdu.SubmitMultiResponse(
                            submitted.status, multi.sequence(), submitted.id, submitted.refused),
                    answer);
        } else if (request instanceof SmppPdu.Query query) {
            answer.accept(query(by, query));
        } else if (request instanceof SmppPdu.Cancel cancel) {
            cancel(by, cancel, answer);
        } else if (request instanceof SmppPdu.Replace replace) {
            replace(by, replace, answer);
        } else {
            throw new SmppViolation(SmppStatus.INVALID_COMMAND_ID, request.command() + " is not for messages");
        }
    }

    /** The result of a submission. */
    private record Submitted(String id, int status, List<SmppPdu.Refused> refused) {}

    /**
     * Submits a message, in all its parts, to all destinations that can be served: all or none.
     *
     * @param responder creates the response
     */
    private void submit(
            Requester by,
            SmppMessage message,
            List<SmppAddress> destinations,
            Function<Submitted, SmppPdu> responder,
            Consumer<SmppPdu> answer)
            throws SmppViolation {
        SmsAddress source = source(message.source(), by);
        Receipts receipts = receipts(message.registeredDelivery());
        requireServed(message.esmClass());
        Optional<Instant> deliverAt = schedule(message.schedule());
        Optional<Instant> expiry = expiry(message.validity(), deliverAt);
        int dataCoding = MessageContent.standardCoding(message.dataCoding(), by.alphabet);
        long firstId = center.nextId();
        List<UserData> texts = MessageContent.parts(message, dataCoding, (int) (firstId % REFERENCES));
        if (texts.size() * destinations.size() > MAX_MESSAGES) {
            throw new SmppViolation(
                    SmppStatus.SUBMIT_FAILED,
                    texts.size() + " parts to " + destinations.size() + " receivers are over " + MAX_MESSAGES);
        }
        List<SmppPdu.Refused> refused = new ArrayList<>();
        List<SubmitTpdu> units = units(message, destinations, texts, firstId, refused);
        if (units.isEmpty()) {
            int status = destinations.size() == 1 ? refused.get(0).status() : SmppStatus.SUBMIT_FAILED;
            answer.accept(responder.apply(new Submitted("", status, refused)));
            return;
        }
        EsmeOrigin origin = new EsmeOrigin(
                by.systemId, source, dataCoding, receipts, EsmeOrigin.Group.SINGLE, deliverAt, message.serviceType());
        // parts are delivered in order, so the last one's id and receipt represent the message
        String id = Long.toString(firstId + units.size() - 1);
        center.submit(origin, source.number().orElse(by.ownNumber), units, expiry, cause -> {
            if (message.replaceIfPresent() != 0 && cause.isEmpty()) {
                units.stream().map(SubmitTpdu::destination).distinct().forEach(to -> cancelReplaced(origin, to));
            }
            answer.accept(responder.apply(cause.map(
                            refusal -> new Submitted("", status(refusal), List.<SmppPdu.Refused>of()))
                    .orElseGet(() -> new Submitted(id, SmppStatus.OK, refused))));
        });
    }

    private static void requireServed(int esmClass) throws SmppViolation {
        if ((esmClass & TYPE_BITS) != 0 || (esmClass & MODE_BITS) == FORWARD_MODE) {
            throw new SmppViolation(SmppStatus.INVALID_ESM_CLASS, "esm_class " + esmClass + " is not served");
        }
    }

    /** The parts for each destination that can be served; the others are added to {@code refused}. */
    private List<SubmitTpdu> units(
            SmppMessage message,
            List<SmppAddress> destinations,
            List<UserData> texts,
            long firstId,
            List<SmppPdu.Refused> refused) {
        List<SubmitTpdu> units = new ArrayList<>();
        for (SmppAddress destination : destinations) {
            int status = refusal(destination, texts.size());
            if (status == SmppStatus.OK) {
                for (UserData text : texts) {
                    units.add(unit(message, destination.number().orElseThrow(), text, firstId + units.size()));
                }
            } else {
                refused.add(new SmppPdu.Refused(destination, status));
            }
        }
        return units;
    }

    /** The status for a destination that cannot be served now. */
    private int refusal(SmppAddress destination, int parts) {
        int unknown = destination.check(SmppStatus.INVALID_DESTINATION_TYPE, SmppStatus.INVALID_DESTINATION_PLAN);
        Optional<Msisdn> number = destination.number();
        return unknown != SmppStatus.OK
                ? unknown
                : number.isEmpty()
                        ? SmppStatus.INVALID_DESTINATION
                        : center.refusal(number.get(), parts)
                                .map(MessageRequests::status)
                                .orElse(SmppStatus.OK);
    }

    private static void requireKnown(SmppAddress source) throws SmppViolation {
        int unknown = source.check(SmppStatus.INVALID_SOURCE_TYPE, SmppStatus.INVALID_SOURCE_PLAN);
        if (unknown != SmppStatus.OK) {
            throw new SmppViolation(unknown, source + " has an unknown type or plan");
        }
    }

    private static SmsAddress source(SmppAddress given, Requester by) throws SmppViolation {
        requireKnown(given);
        if (given.value().isEmpty()) {
            return SmsAddress.of(by.ownNumber);
        }
        if (!by.permits.test(given.value())) {
            throw new SmppViolation(
                    SmppStatus.INVALID_SOURCE, by.systemId + " may not send as \"" + given.value() + "\"");
        }
        return given.forMobiles()
                .orElseThrow(() -> new SmppViolation(
                        SmppStatus.INVALID_SOURCE,
                        "\"" + given.value() + "\" is neither a number nor up to 11 letters"));
    }

    /** The time of delivery; empty for now, and for a past time. */
    private Optional<Instant> schedule(String text) throws SmppViolation {
        Instant now = center.now();
        Optional<Instant> later = text.isEmpty()
                ? Optional.empty()
                : Optional.of(time(text, now, SmppStatus.INVALID_SCHEDULE)).filter(now::isBefore);
        if (later.isPresent() && later.get().isAfter(now.plus(MAX_SCHEDULE))) {
            throw new SmppViolation(
                    SmppStatus.INVALID_SCHEDULE,
                    later.get() + " is more than " + MAX_SCHEDULE.toDays() + " days ahead");
        }
        return later;
    }

    private Optional<Instant> expiry(String text, Optional<Instant> deliverAt) throws SmppViolation {
        if (text.isEmpty()) {
            return Optional.empty();
        }
        Instant now = center.now();
        Instant expiry = time(text, now, SmppStatus.INVALID_VALIDITY);
        if (!expiry.isAfter(deliverAt.orElse(now))) {
            throw new SmppViolation(SmppStatus.INVALID_VALIDITY, "the validity ends before delivery, at " + expiry);
        }
        return Optional.of(expiry);
    }

    private static Instant time(String text, Instant now, int status) throws SmppViolation {
        try {
            return SmppTime.parse(text, now);
        } catch (IllegalArgumentException e) {
            throw new SmppViolation(status, e.getMessage());
        }
    }

    private static Receipts receipts(int registeredDelivery) throws SmppViolation {
        int code = registeredDelivery & RECEIPT_BITS;
        if ((registeredDelivery & ~REGISTERED_DELIVERY_BITS) != 0 || code == RECEIPT_BITS) {
            String text = "registered_delivery " + registeredDelivery + ", expected 0 to 2, or 16 to 18";
            throw new SmppViolation(SmppStatus.INVALID_REGISTERED_DELIVERY, text);
        }
        return Receipts.values()[code];
    }

    private static SubmitTpdu unit(SmppMessage message, Msisdn to, UserData part, long id) {
        return new SubmitTpdu(
                false,
                false,
                (message.esmClass() & SmppMessage.REPLY_PATH) != 0,
                (int) (id % REFERENCES),
                SmsAddress.of(to),
                message.protocolId(),
                Optional.empty(),
                part);
    }

    private static int status(RpCause refusal) {
        return switch (refusal) {
            case UNASSIGNED_NUMBER, UNIDENTIFIED_SUBSCRIBER, UNKNOWN_SUBSCRIBER -> SmppStatus.INVALID_DESTINATION;
            case CONGESTION, MEMORY_CAPACITY_EXCEEDED -> SmppStatus.QUEUE_FULL;
            case NETWORK_OUT_OF_ORDER, TEMPORARY_FAILURE, RESOURCES_UNAVAILABLE -> SmppStatus.SYSTEM_ERROR;
            default -> SmppStatus.SUBMIT_FAILED;
        };
    }

    private SmppPdu query(Requester by, SmppPdu.Query query) throws SmppViolation {
        MessageStatus status = status(by, query.messageId(), query.source(), SmppStatus.QUERY_FAILED);
        boolean hasEnded = status.state() != MessageState.ACCEPTED;
        return new SmppPdu.QueryResponse(
                SmppStatus.OK,
                query.sequence(),
                query.messageId(),
                hasEnded ? SmppTime.full(status.at()) : "",
                DeliverSm.messageState(status.state()),
                0);
    }

    /** Cancels the waiting messages of a submission; without an id all from the source to the destination (4.9). */
    private void cancel(Requester by, SmppPdu.Cancel cancel, Consumer<SmppPdu> answer) throws SmppViolation {
        Stream<Long> ids;
        if (cancel.messageId().isEmpty()) {
            String source = source(cancel.source(), by).value();
            int unknown = refusal(cancel.destination(), 0);
            if (unknown != SmppStatus.OK) {
                throw new SmppViolation(unknown, cancel.destination() + " is no destination");
            }
            ids = center.messages()
                    .sent(by.systemId, source, cancel.destination().number().orElseThrow())
                    .filter(message -> cancel.serviceType().isEmpty() || isOfType(message, cancel.serviceType()))
                    .map(ShortMessage::id);
        } else {
            MessageStatus status = status(by, cancel.messageId(), cancel.source(), SmppStatus.CANCEL_FAILED);
            ids = LongStream.rangeClosed(status.firstId(), status.id()).boxed();
        }
        cancelNext(ids.iterator(), SmppStatus.CANCEL_FAILED, cancel, answer);
    }

    /** Cancels {@link #MAX_MESSAGES} at a time, so that other requests are served. */
    private void cancelNext(Iterator<Long> ids, int before, SmppPdu.Cancel cancel, Consumer<SmppPdu> answer) {
        int status = before;
        for (int i = 0; i < MAX_MESSAGES && ids.hasNext(); i++) {
            status = center.cancel(ids.next()) ? SmppStatus.OK : status;
        }
        int soFar = status;
        if (ids.hasNext()) {
            timers.start(CANCEL_PAUSE_NANOS, () -> cancelNext(ids, soFar, cancel, answer));
        } else {
            answer.accept(new SmppPdu.PlainResponse(SmppCommand.CANCEL_SM, soFar, cancel.sequence()));
        }
    }

    /** Cancels the latest earlier message that a new one replaces (5.2.18), if it waits. */
    private void cancelReplaced(EsmeOrigin by, SmsAddress to) {
        List<ShortMessage> earlier = center.messages()
                .sent(by.systemId(), by.source().value(), to.number().orElseThrow())
                .limit(MAX_MESSAGES)
                .filter(message -> isOfType(message, by.serviceType()))
                .toList();
        earlier.stream()
                .filter(part -> part.submissionId() == earlier.get(0).submissionId())
                .forEach(part -> center.cancel(part.id()));
    }

    private static boolean isOfType(ShortMessage message, String serviceType) {
        return message.esme().orElseThrow().serviceType().equals(serviceType);
    }

    private void replace(Requester by, SmppPdu.Replace replace, Consumer<SmppPdu> answer) throws SmppViolation {
        MessageStatus status = status(by, replace.messageId(), replace.source(), SmppStatus.REPLACE_FAILED);
        Optional<ShortMessage> waiting = center.messages().waitingMessage(status.id());
        if (waiting.isEmpty() || status.firstId() != status.id()) {
            throw new SmppViolation(
                    SmppStatus.REPLACE_FAILED,
                    "message " + replace.messageId() + " has ended, or has several parts or receivers");
        }
        boolean isTaken = center.replace(
                changed(waiting.get(), replace),
                isStored -> answer.accept(new SmppPdu.PlainResponse(
                        SmppCommand.REPLACE_SM,
                        isStored ? SmppStatus.OK : SmppStatus.SYSTEM_ERROR,
                        replace.sequence())));
        if (!isTaken) {
            throw new SmppViolation(
                    SmppStatus.REPLACE_FAILED, "message " + replace.messageId() + " is being delivered");
        }
    }

    private ShortMessage changed(ShortMessage message, SmppPdu.Replace replace) throws SmppViolation {
        EsmeOrigin origin = message.esme().orElseThrow();
        SmppAddress destination = SmppAddress.of(SmsAddress.of(message.to()));
        SmppMessage content = SmppMessage.of(
                replace.source(), destination, 0, 0, origin.dataCoding(), replace.shortMessage(), List.of());
        List<UserData> parts = MessageContent.parts(content, origin.dataCoding(), 0);
        if (parts.size() > 1) {
            throw new SmppViolation(SmppStatus.INVALID_MESSAGE_LENGTH, "the new text is too long for one part");
        }
        Optional<Instant> deliverAt = replace.schedule().isEmpty() ? origin.deliverAt() : schedule(replace.schedule());
        Instant expiry = expiry(replace.validity(), deliverAt).orElse(message.expiresAt());
        if (deliverAt.isPresent() && !expiry.isAfter(deliverAt.get())) {
            throw new SmppViolation(SmppStatus.INVALID_SCHEDULE, "the validity ends before delivery, at " + expiry);
        }
        return new ShortMessage(
                message.id(),
                message.from(),
                message.to(),
                TpduCodec.encode(unit(content, message.to(), parts.get(0), message.id())),
                message.acceptedAt(),
                expiry,
                Optional.of(origin.with(receipts(replace.registeredDelivery()), deliverAt)));
    }

    /** @throws SmppViolation with {@code refusal} if this application has no such message */
    private MessageStatus status(Requester by, String id, SmppAddress source, int refusal) throws SmppViolation {
        requireKnown(source);
        return statuses.find(center, id, by.systemId, source.value())
                .orElseThrow(() -> new SmppViolation(
                        refusal, by.systemId + " has no message \"" + id + "\" that waits or has lately ended"));
    }
}
