package simgsm.center.smpp;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ObjIntConsumer;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.EsmeOrigin.Receipts;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.UserData;

/** Converts submit_sm and data_sm to SUBMITs for the short message centre, and its answer to a command_status. */
final class SubmitHandler {
    /** TP-MR and the reference of concatenated parts are one octet. */
    private static final int REFERENCES = 256;

    private static final int RECEIPT_BITS = 0x03;

    private final ShortMessageCenter center;

    SubmitHandler(ShortMessageCenter center) {
        this.center = center;
    }

    /**
     * Submits a message, in as many parts as it needs: all or none.
     *
     * @param ownNumber replaces an empty source address
     * @param answer called once, with the message's id and a status of {@link SmppStatus}
     */
    void submit(String systemId, Msisdn ownNumber, SmppMessage message, ObjIntConsumer<String> answer)
            throws SmppViolation {
        Msisdn to = message.destination()
                .number()
                .orElseThrow(() -> new SmppViolation(
                        SmppStatus.INVALID_DESTINATION,
                        "\"" + message.destination().value() + "\" is not a telephone number"));
        SmsAddress source = source(message, ownNumber);
        Optional<Instant> expiry = expiry(message);
        long firstId = center.nextId();
        List<SubmitTpdu> parts = new ArrayList<>();
        for (UserData part : MessageContent.parts(message, (int) (firstId % REFERENCES))) {
            parts.add(unit(message, to, part, firstId + parts.size()));
        }
        EsmeOrigin origin =
                new EsmeOrigin(systemId, source, message.dataCoding(), receipts(message.registeredDelivery()));
        // Parts are delivered in order, so the last one's id and receipt stand for the message.
        String id = Long.toString(firstId + parts.size() - 1);
        center.submit(
                origin,
                source.number().orElse(ownNumber),
                to,
                parts,
                expiry,
                refusal -> answer.accept(id, refusal.map(SubmitHandler::status).orElse(SmppStatus.OK)));
    }

    private static SmsAddress source(SmppMessage message, Msisdn ownNumber) throws SmppViolation {
        if (message.source().value().isEmpty()) {
            return SmsAddress.of(ownNumber);
        }
        return message.source()
                .forMobiles()
                .orElseThrow(() -> new SmppViolation(
                        SmppStatus.INVALID_SOURCE,
                        "\"" + message.source().value() + "\" is neither a number nor up to 11 letters"));
    }

    private Optional<Instant> expiry(SmppMessage message) throws SmppViolation {
        Instant now = center.now();
        if (!message.schedule().isEmpty()
                && time(message.schedule(), now, SmppStatus.INVALID_SCHEDULE).isAfter(now)) {
            throw new SmppViolation(SmppStatus.INVALID_SCHEDULE, "scheduled delivery is not supported");
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
}
