package simgsm.center.smpp;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.EsmeOrigin.Receipts;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.UserData;

/** Takes what applications hand in: to the short message centre, and its answer back. */
final class SubmitHandler {
    private static final int REFERENCES = 256;
    private static final int RECEIPT_BITS = 0x03;

    private final ShortMessageCenter center;

    SubmitHandler(ShortMessageCenter center) {
        this.center = center;
    }

    /**
     * Hands a message in, in as many parts as it takes.
     *
     * @param ownNumber stands for a source that is left out
     * @param answer told once, with a status of {@link SmppStatus}
     * @return the message's id, should the status be OK
     */
    String submit(String systemId, Msisdn ownNumber, SmppMessage message, IntConsumer answer) throws SmppViolation {
        Msisdn to = message.destination()
                .number()
                .orElseThrow(() -> new SmppViolation(
                        SmppStatus.INVALID_DESTINATION,
                        "\"" + message.destination().value() + "\" is not a telephone number"));
        SmsAddress source = source(message, ownNumber);
        Optional<Instant> expiry = expiry(message);
        List<UserData> parts = MessageContent.parts(message, (int) (center.nextId() % REFERENCES));
        Receipts receipts = receipts(message.registeredDelivery());
        Msisdn from = source.number().orElse(ownNumber);
        Parts answers = new Parts(parts.size(), answer);
        long id = 0;
        for (int i = 0; i < parts.size(); i++) {
            // Parts go in order, so the last one stands for the message.
            boolean isLast = i == parts.size() - 1;
            id = center.nextId();
            EsmeOrigin origin =
                    new EsmeOrigin(systemId, source, message.dataCoding(), isLast ? receipts : Receipts.NONE);
            center.submit(origin, from, to, unit(message, to, parts.get(i), id), expiry, answers::answered);
        }
        return Long.toString(id);
    }

    private static SmsAddress source(SmppMessage message, Msisdn ownNumber) throws SmppViolation {
        if (message.source().value().isEmpty()) {
            return SmsAddress.of(ownNumber);
        }
        return message.source()
                .forMobiles()
                .orElseThrow(() -> new SmppViolation(
                        SmppStatus.INVALID_SOURCE,
                        "\"" + message.source().value() + "\" is no number and no name of 11 letters"));
    }

    private Optional<Instant> expiry(SmppMessage message) throws SmppViolation {
        Instant now = center.now();
        if (!message.schedule().isEmpty()
                && time(message.schedule(), now, SmppStatus.INVALID_SCHEDULE).isAfter(now)) {
            throw new SmppViolation(SmppStatus.INVALID_SCHEDULE, "messages are sent at once, not on a schedule");
        }
        if (message.validity().isEmpty()) {
            return Optional.empty();
        }
        Instant expiry = time(message.validity(), now, SmppStatus.INVALID_VALIDITY);
        if (!expiry.isAfter(now)) {
            throw new SmppViolation(SmppStatus.INVALID_VALIDITY, "the validity ended at " + expiry);
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

    private static Receipts receipts(int registeredDelivery) {
        int code = registeredDelivery & RECEIPT_BITS;
        return code < Receipts.values().length ? Receipts.values()[code] : Receipts.NONE;
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

    /** One answer for all parts: the first refusal, or OK when the last is stored. */
    private static final class Parts {
        private final IntConsumer answer;
        private int open;
        private int status = SmppStatus.OK;

        Parts(int count, IntConsumer answer) {
            this.open = count;
            this.answer = answer;
        }

        void answered(Optional<RpCause> refusal) {
            if (status == SmppStatus.OK && refusal.isPresent()) {
                status = SubmitHandler.status(refusal.get());
            }
            if (--open == 0) {
                answer.accept(status);
            }
        }
    }
}
