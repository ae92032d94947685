package simgsm.center.smpp;

import java.nio.charset.StandardCharsets;
import java.util.List;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.octets.OctetString;
import simgsm.sms.Alphabet;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.SmsAddress;
import simgsm.sms.UserData;

/** The content of deliver_sm: messages, and delivery receipts (appendix B). */
final class DeliverSm {
    static final int ENROUTE = 1;

    /** Characters of the message that its receipt quotes. */
    private static final int TEXT_LENGTH = 20;

    private static final int NO_DATA_CODING = -1;

    private DeliverSm() {}

    static SmppMessage of(Envelope envelope) {
        return envelope instanceof Envelope.Report report ? receipt(report) : message(envelope.message());
    }

    private static SmppMessage message(ShortMessage message) {
        MessageContent.Translated content = MessageContent.translate(
                message.userData(), message.esme().map(EsmeOrigin::dataCoding).orElse(NO_DATA_CODING));
        return SmppMessage.of(
                SmppAddress.of(message.sender()),
                SmppAddress.of(SmsAddress.of(message.to())),
                content.hasHeader() ? SmppMessage.HAS_HEADER : 0,
                0,
                content.dataCoding(),
                content.octets(),
                List.of(Tlv.ofTwoOctets(Tlv.USER_MESSAGE_REFERENCE, (int) (message.id() & 0xffff))));
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

    /** Its source is the destination of the message, and the other way round. */
    private static SmppMessage receipt(Envelope.Report report) {
        ShortMessage message = report.message();
        String text =
                "id:" + message.id() + " sub:001 dlvrd:" + (report.state() == MessageState.DELIVERED ? "001" : "000")
                        + " submit date:" + SmppTime.minutes(message.acceptedAt())
                        + " done date:" + SmppTime.minutes(report.at()) + " stat:" + word(report.state()) + " err:"
                        + error(report.state()) + " text:" + excerpt(message.userData());
        return SmppMessage.of(
                SmppAddress.of(SmsAddress.of(message.to())),
                SmppAddress.of(message.sender()),
                SmppMessage.RECEIPT,
                0,
                0,
                OctetString.of(text.getBytes(StandardCharsets.US_ASCII)),
                List.of(
                        Tlv.ofText(Tlv.RECEIPTED_MESSAGE_ID, Long.toString(message.id())),
                        Tlv.ofOctet(Tlv.MESSAGE_STATE, messageState(report.state()))));
    }

    private static String excerpt(UserData data) {
        if (data.coding().alphabet() == Alphabet.OCTETS) {
            return "";
        }
        String text = data.text();
        StringBuilder excerpt = new StringBuilder(TEXT_LENGTH);
        for (int i = 0; i < Math.min(TEXT_LENGTH, text.length()); i++) {
            excerpt.append(isSameInAsciiAndGsm(text.charAt(i)) ? text.charAt(i) : '.');
        }
        return excerpt.toString();
    }

    /** Some applications read receipts as ASCII, others in the GSM alphabet. */
    private static boolean isSameInAsciiAndGsm(char c) {
        return c >= ' ' && c <= '?' && c != '$' || c >= 'A' && c <= 'Z' || c >= 'a' && c <= 'z';
    }
}
