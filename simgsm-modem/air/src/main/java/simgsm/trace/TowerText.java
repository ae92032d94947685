package simgsm.trace;

import java.util.ArrayList;
import java.util.List;
import simgsm.abis.rsl.RslElement;
import simgsm.abis.rsl.RslPdu;
import simgsm.air.ChannelNumber;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText.Field;

/** RSL between a tower and its controller in words: the elements in their order. */
public final class TowerText {
    private TowerText() {}

    /** The text of a message. */
    public static MessageText of(RslPdu message) {
        List<Field> fields = new ArrayList<>();
        message.elements().forEach((element, value) -> fields.add(new Field(element.toString(), text(element, value))));
        return new MessageText(message.type().title(), fields, OctetString.of(message.encode()));
    }

    private static String text(RslElement element, OctetString value) {
        return switch (element) {
            case CHANNEL_NUMBER -> channel(value);
            case LOCAL_IP, REMOTE_IP -> address(value);
            case LOCAL_PORT, REMOTE_PORT -> String.valueOf(value.octet(0) << 8 | value.octet(1));
            case HANDOVER_REFERENCE, TIMING_ADVANCE, ACCESS_DELAY, PAGING_GROUP, SYSTEM_INFORMATION_TYPE, RTP_PAYLOAD ->
                String.valueOf(value.octet(0));
            case LINK_IDENTIFIER -> "SAPI " + (value.octet(0) & 0x07);
            default -> value.length() == 0 ? "empty" : value.toString();
        };
    }

    private static String channel(OctetString value) {
        try {
            return ChannelNumber.ofCode(value.octet(0)).toString();
        } catch (ProtocolViolation violation) {
            return value.toString();
        }
    }

    private static String address(OctetString value) {
        return value.octet(0) + "." + value.octet(1) + "." + value.octet(2) + "." + value.octet(3);
    }
}
