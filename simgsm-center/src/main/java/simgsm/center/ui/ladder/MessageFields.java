package simgsm.center.ui.ladder;

import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.StringJoiner;
import simgsm.abis.RslCodec;
import simgsm.abis.RslMessage;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.sms.CellBroadcast;
import simgsm.sms.CellBroadcastPage;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;
import simgsm.trace.MessageText;
import simgsm.trace.TpduText;

/** A message as lines of text: its fields, those of a short message or broadcast page inside, and its octets. */
final class MessageFields {
    static final int WIDE = 16;
    static final int NARROW = 8;
    private static final int NAME_WIDTH = 22;
    private static final HexFormat HEX = HexFormat.ofDelimiter(" ");

    private MessageFields() {}

    /** @param octetsPerLine {@link #WIDE} or {@link #NARROW} */
    static String of(LadderRow row, int octetsPerLine) {
        StringJoiner lines = new StringJoiner("\n");
        OctetString octets = row.entry().octets();
        if (Protocol.of(row.entry()) == Protocol.COMMON_CHANNEL) {
            addCommonChannel(lines, octets);
        } else {
            MessageText.ofLayer3(octets, row.direction()).fields().forEach(field -> add(lines, field));
            MessageText.tpdu(octets, row.direction()).ifPresent(tpdu -> addTpdu(lines, tpdu, row));
        }
        lines.add("");
        addOctets(lines, octets.toArray(), octetsPerLine);
        return lines.toString().stripLeading();
    }

    private static void addCommonChannel(StringJoiner lines, OctetString octets) {
        try {
            RslMessage message = RslCodec.decode(octets.toArray());
            if (message instanceof RslMessage.SmsBroadcastCommand broadcast) {
                addPage(lines, CellBroadcastPage.decode(broadcast.page()));
            } else {
                MessageText.ofRsl(message).fields().forEach(field -> add(lines, field));
            }
        } catch (ProtocolViolation violation) {
            lines.add(violation.getMessage());
        }
    }

    private static void addPage(StringJoiner lines, CellBroadcastPage page) {
        Optional<String> language = CellBroadcast.join(List.of(page)).language();
        add(lines, new MessageText.Field("channel", String.valueOf(page.messageIdentifier())));
        add(
                lines,
                new MessageText.Field(
                        "message code", String.valueOf(page.serial().code())));
        add(lines, new MessageText.Field("update", String.valueOf(page.serial().update())));
        add(lines, new MessageText.Field("page", page.page() + " of " + page.pages()));
        language.ifPresent(name -> add(lines, new MessageText.Field("language", name)));
        add(
                lines,
                new MessageText.Field("text", CellBroadcast.join(List.of(page)).text()));
    }

    private static void addTpdu(StringJoiner lines, OctetString tpdu, LadderRow row) {
        try {
            Tpdu unit = TpduCodec.decode(tpdu, row.direction());
            text(unit).ifPresent(text -> add(lines, new MessageText.Field("text", text)));
            lines.add("");
            lines.add(TpduText.of(unit));
        } catch (ProtocolViolation violation) {
            lines.add(violation.getMessage());
        }
    }

    private static Optional<String> text(Tpdu unit) {
        if (unit instanceof SubmitTpdu submit) {
            return Optional.of(submit.userData().text());
        }
        return unit instanceof DeliverTpdu deliver
                ? Optional.of(deliver.userData().text())
                : Optional.empty();
    }

    private static void add(StringJoiner lines, MessageText.Field field) {
        if (!field.name().equals("tpdu")) {
            lines.add(field.name()
                    + " ".repeat(Math.max(1, NAME_WIDTH - field.name().length()))
                    + field.value());
        }
    }

    private static void addOctets(StringJoiner lines, byte[] octets, int octetsPerLine) {
        for (int start = 0; start < octets.length; start += octetsPerLine) {
            int end = Math.min(octets.length, start + octetsPerLine);
            lines.add(String.format("%04x  %s", start, HEX.formatHex(octets, start, end)));
        }
    }
}
