package simgsm.center.smpp;

import java.util.List;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.octets.OctetString;
import simgsm.sms.Alphabet;
import simgsm.sms.DeliveryStatus;
import simgsm.sms.SmsAddress;
import simgsm.sms.UserData;

/** What became of a message, in the words of SMPP (5.2.28, appendix B). */
final class Receipts {
    static final int ENROUTE = 1;

    private static final int TEXT_LENGTH = 20;

    private Receipts() {}

    /** message_state. */
    static int code(MessageState state) {
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

    /** TP-ST of the status report that a mobile would get. */
    private static String error(MessageState state) {
        int status = switch (state) {
            case ACCEPTED, DELIVERED -> DeliveryStatus.DELIVERED;
            case EXPIRED -> DeliveryStatus.VALIDITY_EXPIRED;
            case DELETED -> DeliveryStatus.DELETED_BY_ORIGINATOR;
            case REJECTED -> DeliveryStatus.CONNECTION_REJECTED_BY_RECEIVER;
        };
        return String.valueOf(1_000 + status).substring(1);
    }

    /** From the receiver of the message to its sender. */
    static SmppMessage of(Envelope.Report report) {
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
                OctetString.of(ascii(text)),
                List.of(
                        Tlv.ofText(Tlv.RECEIPTED_MESSAGE_ID, Long.toString(message.id())),
                        Tlv.ofOctet(Tlv.MESSAGE_STATE, code(report.state()))));
    }

    private static String excerpt(UserData data) {
        if (data.coding().alphabet() == Alphabet.OCTETS) {
            return "";
        }
        String text = data.text();
        StringBuilder excerpt = new StringBuilder(TEXT_LENGTH);
        for (int i = 0; i < Math.min(TEXT_LENGTH, text.length()); i++) {
            excerpt.append(isTheSameInBoth(text.charAt(i)) ? text.charAt(i) : '.');
        }
        return excerpt.toString();
    }

    /** Receipts are read as ASCII and as the GSM alphabet; only what both know alike goes in. */
    private static boolean isTheSameInBoth(char c) {
        return c >= ' ' && c <= '?' && c != '$' || c >= 'A' && c <= 'Z' || c >= 'a' && c <= 'z';
    }

    private static byte[] ascii(String text) {
        byte[] octets = new byte[text.length()];
        for (int i = 0; i < octets.length; i++) {
            octets[i] = (byte) text.charAt(i);
        }
        return octets;
    }
}
