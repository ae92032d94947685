package simgsm.trace;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.ChannelNumber;
import simgsm.air.IdentityElements;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.sms.CellBroadcast;
import simgsm.sms.CellBroadcastPage;

/** RSL messages in words: the elements in order; of a cell broadcast its page. */
final class RslText {
    private static final int HEADER_LENGTH = 2;

    private RslText() {}

    /** @param octets decoded as the message */
    static MessageText of(RslPdu message, OctetString octets, Locale language) {
        FieldList fields = new FieldList(FieldTexts.in(language));
        int at = HEADER_LENGTH;
        for (Map.Entry<RslElement, OctetString> entry : message.elements().entrySet()) {
            int from = at;
            at += entry.getKey().overhead() + entry.getValue().length();
            try {
                if (message.type() != RslType.SMS_BROADCAST_COMMAND) {
                    fields.add(entry.getKey().name(), text(entry.getKey(), entry.getValue(), fields.texts()), from, at);
                } else if (entry.getKey() == RslElement.BROADCAST_MESSAGE) {
                    addPage(fields, CellBroadcastPage.decode(entry.getValue()), at);
                }
            } catch (ProtocolViolation violation) {
                fields.add(entry.getKey().name(), entry.getValue(), from, at);
            }
        }
        return new MessageText(message.type().title(), fields.fields(), octets);
    }

    private static void addPage(FieldList fields, CellBroadcastPage page, int to) {
        CellBroadcast joined = CellBroadcast.join(List.of(page));
        int start = to - CellBroadcastPage.LENGTH;
        fields.add("channel", page.messageIdentifier(), start + 2, start + 4);
        fields.add("messageCode", page.serial().code(), start, start + 2);
        fields.add("update", page.serial().update(), start + 1, start + 2);
        fields.add("page", fields.texts().of("pageOf", page.page(), page.pages()), start + 5, start + 6);
        joined.language().ifPresent(name -> fields.add("language", name, start + 4, start + 5));
        fields.add("text", joined.text(), start + 6, to);
    }

    private static Object text(RslElement element, OctetString value, FieldTexts texts) throws ProtocolViolation {
        MessageReader in = new MessageReader(value);
        return switch (element) {
            case CHANNEL_NUMBER -> ChannelNumber.ofCode(value.octet(0));
            case MOBILE_IDENTITY -> IdentityElements.read(in);
            case LOCAL_IP, REMOTE_IP ->
                value.octet(0) + "." + value.octet(1) + "." + value.octet(2) + "." + value.octet(3);
            case LOCAL_PORT, REMOTE_PORT -> in.twoOctets("port");
            case HANDOVER_REFERENCE, TIMING_ADVANCE, ACCESS_DELAY, PAGING_GROUP, SYSTEM_INFORMATION_TYPE, RTP_PAYLOAD ->
                value.octet(0);
            case LINK_IDENTIFIER -> "SAPI " + (value.octet(0) & 0x07);
            default -> value.length() == 0 ? texts.of("empty") : value;
        };
    }
}
