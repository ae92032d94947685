package simgsm.center.smsc;

import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.function.UnaryOperator;
import simgsm.air.Cause;
import simgsm.air.Direction;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.Timestamp;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.SmsAddress;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;

/** Converts accepted messages to transfer protocol data units and back (TS 23.040, 9.2.2). */
final class TransferUnits {
    private TransferUnits() {}

    /**
     * Decodes a SUBMIT into a message.
     *
     * @param called number that was dialled so
     * @throws ProtocolViolation if the octets are no SUBMIT, or the destination is no telephone number
     */
    static ShortMessage accept(
            long id,
            Msisdn from,
            OctetString octets,
            Instant now,
            Duration defaultValidity,
            UnaryOperator<Msisdn> called)
            throws ProtocolViolation {
        SubmitTpdu submit = decode(octets);
        Msisdn to = submit.destination()
                .number()
                .map(called)
                .orElseThrow(() -> new ProtocolViolation(
                        Cause.UNASSIGNED_NUMBER, "\"" + submit.destination() + "\" is not a telephone number"));
        Instant expiry = submit.validity().map(period -> period.expiry(now)).orElse(now.plus(defaultValidity));
        return new ShortMessage(id, from, to, octets, now, expiry);
    }

    private static SubmitTpdu decode(OctetString octets) throws ProtocolViolation {
        if (TpduCodec.decode(octets, Direction.UPLINK) instanceof SubmitTpdu submit) {
            return submit;
        }
        throw new ProtocolViolation(Cause.MESSAGE_TYPE_NON_EXISTENT, "a SUBMIT was expected");
    }

    /** The SUBMIT of an accepted message, which was decoded before. */
    static SubmitTpdu submitOf(ShortMessage message) {
        try {
            return decode(message.submit());
        } catch (ProtocolViolation impossible) {
            throw new IllegalStateException("message " + message.id() + " holds no SUBMIT", impossible);
        }
    }

    static boolean wantsReport(ShortMessage message, MessageState state) {
        return message.esme().isPresent()
                ? message.esme().get().receipts().areWantedFor(state)
                : submitOf(message).statusReportRequest();
    }

    static OctetString deliver(ShortMessage message, boolean moreWaiting, UnaryOperator<Msisdn> shown) {
        SubmitTpdu submit = submitOf(message);
        return TpduCodec.encode(new DeliverTpdu(
                moreWaiting,
                submit.statusReportRequest(),
                submit.replyPath(),
                message.esme().map(EsmeOrigin::source).orElseGet(() -> SmsAddress.of(shown.apply(message.from()))),
                submit.protocolIdentifier(),
                timestamp(message.acceptedAt()),
                submit.userData()));
    }

    static OctetString statusReport(ShortMessage message, MessageState state, Instant at, boolean moreWaiting) {
        SubmitTpdu submit = submitOf(message);
        return TpduCodec.encode(new StatusReportTpdu(
                moreWaiting,
                submit.reference(),
                submit.destination(),
                timestamp(message.acceptedAt()),
                timestamp(at),
                status(state)));
    }

    private static int status(MessageState state) {
        return switch (state) {
            case DELIVERED -> DeliveryStatus.DELIVERED;
            case EXPIRED -> DeliveryStatus.VALIDITY_EXPIRED;
            case REJECTED -> DeliveryStatus.CONNECTION_REJECTED_BY_RECEIVER;
            case DELETED -> DeliveryStatus.DELETED_BY_ORIGINATOR;
            case ACCEPTED -> throw new IllegalArgumentException("a message under way has no final status");
        };
    }

    static String text(ShortMessage message) {
        return submitOf(message).userData().shownText();
    }

    /** A time stamp in UTC; the zone octet is 0. */
    private static Timestamp timestamp(Instant instant) {
        return Timestamp.of(instant.atOffset(ZoneOffset.UTC));
    }
}
