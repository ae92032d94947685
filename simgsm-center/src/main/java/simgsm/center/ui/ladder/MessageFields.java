package simgsm.center.ui.ladder;

import java.util.HexFormat;
import java.util.Locale;
import java.util.StringJoiner;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText;

/** A message of the ladder in words. */
final class MessageFields {
    private static final int OCTETS_PER_LINE = 16;
    private static final int NAME_WIDTH = 22;
    private static final HexFormat HEX = HexFormat.ofDelimiter(" ");

    private MessageFields() {}

    static MessageText of(LadderRow row, Locale language) {
        OctetString octets = row.entry().octets();
        return Protocol.of(row.entry()) == Protocol.COMMON_CHANNEL
                ? MessageText.ofRsl(octets, language)
                : MessageText.ofLayer3(octets, row.direction(), language);
    }

    /** A line for each field, an empty one, and the octets, 16 in a line. */
    static String lines(MessageText message) {
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
