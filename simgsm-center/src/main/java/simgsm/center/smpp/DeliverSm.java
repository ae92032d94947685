package simgsm.center.smpp;

import java.util.List;
import java.util.Optional;
import simgsm.center.smpp.EsmeSettings.EsmeAlphabet;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppTime;
import simgsm.smpp.Tlv;
import simgsm.sms.Alphabet;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.SmsAddress;
import simgsm.sms.UserData;

/** The content of deliver_sm: messages, and delivery receipts (appendix B). */
final class DeliverSm {
    static final int ENROUTE = 1;

    /** Number of the message's characters quoted in its receipt. */
    private static final int TEXT_LENGTH = 20;

    private static final int NO_DATA_CODING = -1;

    private DeliverSm() {}

    /**
     * @param own the application's alphabet, if any
     * @param takesPayload true if a text of over 254 octets may be sent as message_payload
     */
    static SmppMessage of(Envelope envelope, Optional<EsmeAlphabet> own, boolean takesPayload) {
        if (envelope instanceof Envelope.Report report) {
            return receipt(report, own);
        }
        SmppMessage message = message(envelope.message(), own);
        // in the standard's alphabets a message has at most 160 octets
        return takesPayload || message.parameter(Tlv.MESSAGE_PAYLOAD).isEmpty()
                ? message
                : message(envelope.message(), Optional.empty());
    }

    private static SmppMessage message(ShortMessage message, Optional<EsmeAlphabet> own) {
        MessageContent.Translated content = MessageContent.translate(
                message.userData(), message.esme().map(EsmeOrigin::dataCoding).orElse(NO_DATA_CODING), own);
        boolean isShort = content.octets().length() <= SmppMessage.MAX_SHORT_MESSAGE;
        Tlv reference = Tlv.ofTwoOctets(Tlv.USER_MESSAGE_REFERENCE, (int) (message.id() & 0xffff));
        return SmppMessage.of(
                SmppAddress.of(message.sender()),
                SmppAddress.of(SmsAddress.of(message.to())),
                content.hasHeader() ? SmppMessage.HAS_HEADER : 0,
                0,
                content.dataCoding(),
                isShort ? content.octets() : OctetString.of(new byte[0]),
                isShort ? List.of(reference) : List.of(reference, new Tlv(Tlv.MESSAGE_PAYLOAD, content.octets())));
    }

    /** message_state (5.2.28). */
    static int messageState(MessageState state) {
        return switch (state) {
            case ACCEPTED -> ENROUTE;
            case DELIVERED -> 2;
            case EXPIRED -> 3;
            case DELETED -> 4;
            case REJECTED -> 5;
        };
    }

    private static String word(MessageState state) {
        return switch (state) {
            case ACCEPTED -> "ACCEPTD";
            case DELIVERED -> "DELIVRD";
            case EXPIRED -> "EXPIRED";
            case DELETED -> "DELETED";
            case REJECTED -> "UNDELIV";
        };
    }

    /** The value of TP-ST in a status report to a mobile, three digits. */
    private static String error(MessageState state) {
        int status = switch (state) {
            case ACCEPTED, DELIVERED -> DeliveryStatus.DELIVERED;
            case EXPIRED -> DeliveryStatus.VALIDITY_EXPIRED;
            case DELETED -> DeliveryStatus.DELETED_BY_ORIGINATOR;
            case REJECTED -> DeliveryStatus.CONNECTION_REJECTED_BY_RECEIVER;
        };
        return String.valueOf(1_000 + status).substring(1);
    }

    /** Creates a receipt; its source is the destination of the message, and vice versa. */
    private static SmppMessage receipt(Envelope.Report report, Optional<EsmeAlphabet> own) {
        ShortMessage message = report.message();
        String text = "id:" + message.submissionId() + " sub:001 dlvrd:"
                + (report.state() == MessageState.DELIVERED ? "001" : "000")
                + " submit date:" + SmppTime.minutes(message.acceptedAt())
                + " done date:" + SmppTime.minutes(report.at()) + " stat:" + word(report.state()) + " err:"
                + error(report.state()) + " text:" + excerpt(message.userData(), own);
        return SmppMessage.of(
                SmppAddress.of(SmsAddress.of(message.to())),
                SmppAddress.of(message.sender()),
                SmppMessage.RECEIPT,
                0,
                0,
                OctetString.of(MessageContent.encode(text, own.orElse(EsmeAlphabet.ASCII))
                        .orElseThrow()),
                List.of(
                        Tlv.ofText(Tlv.RECEIPTED_MESSAGE_ID, Long.toString(message.submissionId())),
                        Tlv.ofOctet(Tlv.MESSAGE_STATE, messageState(report.state()))));
    }

    /** The first characters; a dot replaces each that the application might misread. */
    private static String excerpt(UserData data, Optional<EsmeAlphabet> own) {
        if (data.coding().alphabet() == Alphabet.OCTETS) {
            return "";
        }
        StringBuilder excerpt = new StringBuilder(TEXT_LENGTH);
        data.text().codePoints().limit(TEXT_LENGTH).forEach(c -> {
            String character = Character.toString(c);
            boolean isQuoted = own.isPresent()
                    ? c >= ' ' && MessageContent.encode(character, own.get()).isPresent()
                    : isSameInAsciiAndGsm(c);
            excerpt.append(isQuoted ? character : ".");
        });
        return excerpt.toString();
    }

    /** Some applications read receipts as ASCII, others in the GSM alphabet. */
    private static boolean isSameInAsciiAndGsm(int c) {
        return c >= ' ' && c <= '?' && c != '$' || c >= 'A' && c <= 'Z' || c >= 'a' && c <= 'z';
    }
}
