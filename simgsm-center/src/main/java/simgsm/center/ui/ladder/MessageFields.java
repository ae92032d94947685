package simgsm.center.ui.ladder;

import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.StringJoiner;
import simgsm.abis.RslCodec;
import simgsm.abis.RslMessage;
import simgsm.abis.rsl.RslPdu;
import simgsm.air.Direction;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.sms.CellBroadcast;
import simgsm.sms.CellBroadcastPage;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;
import simgsm.trace.FieldOctets;
import simgsm.trace.MessageText;
import simgsm.trace.MessageText.Field;
import simgsm.trace.TowerText;
import simgsm.trace.TpduText;

/** All fields of a message of the ladder, those of the short message or broadcast page inside as well, and their octets. */
final class MessageFields {
    private static final int OCTETS_PER_LINE = 16;
    private static final int NAME_WIDTH = 22;
    private static final HexFormat HEX = HexFormat.ofDelimiter(" ");

    private final LadderRow row;
    private final MessageText message;
    private FieldOctets octets;

    private MessageFields(LadderRow row) {
        this.row = row;
        this.message = textOf(row);
    }

    static MessageFields of(LadderRow row) {
        return new MessageFields(row);
    }

    MessageText message() {
        return message;
    }

    /** Where the fields stand; found when it is asked for first, in about 0.1 s for the longest messages. */
    FieldOctets octets() {
        if (octets == null) {
            boolean isCommon = isCommon(row);
            octets = new FieldOctets(message, other -> read(other, row.direction(), isCommon));
        }
        return octets;
    }

    /** The fields without their octets. */
    static MessageText textOf(LadderRow row) {
        return read(row.entry().octets(), row.direction(), isCommon(row));
    }

    private static boolean isCommon(LadderRow row) {
        return Protocol.of(row.entry()) == Protocol.COMMON_CHANNEL;
    }

    private static MessageText read(OctetString octets, Direction direction, boolean isCommon) {
        return isCommon ? commonChannel(octets) : layer3(octets, direction);
    }

    private static MessageText layer3(OctetString octets, Direction direction) {
        MessageText message = MessageText.ofLayer3(octets, direction);
        List<Field> fields = new ArrayList<>(message.fields());
        fields.removeIf(field -> field.name().equals("tpdu"));
        MessageText.tpdu(octets, direction).ifPresent(tpdu -> addTpdu(fields, tpdu, direction));
        return new MessageText(message.name(), fields, octets);
    }

    private static MessageText commonChannel(OctetString octets) {
        try {
            RslMessage message = RslCodec.decode(octets.toArray());
            return message instanceof RslMessage.SmsBroadcastCommand broadcast
                    ? new MessageText(
                            MessageText.nameOf(message), page(CellBroadcastPage.decode(broadcast.page())), octets)
                    : new MessageText(
                            MessageText.nameOf(message),
                            MessageText.ofRsl(message).fields(),
                            octets);
        } catch (ProtocolViolation violation) {
            return ofTower(octets);
        }
    }

    private static MessageText ofTower(OctetString octets) {
        try {
            MessageText message = TowerText.of(RslPdu.decode(octets.toArray()));
            return new MessageText(message.name(), message.fields(), octets);
        } catch (ProtocolViolation violation) {
            return new MessageText("?", List.of(new Field(FieldOctets.WRONG, violation.getMessage())), octets);
        }
    }

    private static List<Field> page(CellBroadcastPage page) {
        CellBroadcast joined = CellBroadcast.join(List.of(page));
        List<Field> fields = new ArrayList<>();
        fields.add(new Field("channel", String.valueOf(page.messageIdentifier())));
        fields.add(new Field("message code", String.valueOf(page.serial().code())));
        fields.add(new Field("update", String.valueOf(page.serial().update())));
        fields.add(new Field("page", page.page() + " of " + page.pages()));
        joined.language().ifPresent(name -> fields.add(new Field("language", name)));
        fields.add(new Field("text", joined.text()));
        return fields;
    }

    /** A text comes first; the unit's own fields follow. */
    private static void addTpdu(List<Field> fields, OctetString tpdu, Direction direction) {
        try {
            Tpdu unit = TpduCodec.decode(tpdu, direction);
            Optional<String> text = text(unit);
            text.ifPresent(words -> fields.add(new Field("text", words)));
            TpduText.fieldsOf(unit).stream()
                    .filter(field -> text.isEmpty() || !field.name().equals("text"))
                    .forEach(fields::add);
        } catch (ProtocolViolation violation) {
            fields.add(new Field(FieldOctets.WRONG, violation.getMessage()));
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

    /** A line for each field, an empty one, and the octets, 16 in a line. */
    String lines() {
        StringJoiner lines = new StringJoiner("\n");
        message.fields()
                .forEach(field -> lines.add(field.name()
                        + " ".repeat(Math.max(1, NAME_WIDTH - field.name().length()))
                        + field.value().replace("\n", "\n" + " ".repeat(NAME_WIDTH))));
        lines.add("");
        byte[] all = message.octets().toArray();
        for (int start = 0; start < all.length; start += OCTETS_PER_LINE) {
            int end = Math.min(all.length, start + OCTETS_PER_LINE);
            lines.add(String.format("%04x  %s", start, HEX.formatHex(all, start, end)));
        }
        return lines.toString().stripLeading();
    }
}
