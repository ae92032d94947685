package simgsm.modem.at.state;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import simgsm.sms.GsmAlphabet;

/** Character sets between client and modem (TS 27.007, 5.5). Each character of a line represents an octet. */
public enum CharacterSet {
    /** The GSM default alphabet, one septet an octet. */
    GSM,
    /** ITU-T T.50: ASCII. */
    IRA,
    /** Four hexadecimal digits for each unit of UTF-16. */
    UCS2,
    /** Two hexadecimal digits for each octet of the GSM default alphabet; of UTF-16 for a text outside it. */
    HEX;

    private static final char UNKNOWN = '?';

    /** The text of a client's line; IllegalArgumentException for characters outside the set. */
    public String decode(String line) {
        return switch (this) {
            case GSM -> GsmAlphabet.decode(line.getBytes(StandardCharsets.ISO_8859_1));
            case IRA -> line;
            case HEX -> GsmAlphabet.decode(HexFormat.of().parseHex(line));
            case UCS2 -> {
                byte[] octets = HexFormat.of().parseHex(line);
                if (octets.length % 2 != 0) {
                    throw new IllegalArgumentException("expected four digits a character, found " + line);
                }
                yield new String(octets, StandardCharsets.UTF_16BE);
            }
        };
    }

    /** The text in this set; a question mark for characters outside it. */
    public String encode(String text) {
        if (this == HEX && GsmAlphabet.encodes(text)) {
            return HexFormat.of().withUpperCase().formatHex(GsmAlphabet.encode(text));
        }
        if (this == UCS2 || this == HEX) {
            return HexFormat.of().withUpperCase().formatHex(text.getBytes(StandardCharsets.UTF_16BE));
        }
        StringBuilder line = new StringBuilder(text.length());
        text.chars().forEach(each -> {
            String character = String.valueOf((char) each);
            if (this == IRA) {
                line.append(each < 0x80 ? (char) each : UNKNOWN);
            } else {
                String known = GsmAlphabet.encodes(character) ? character : String.valueOf(UNKNOWN);
                line.append(new String(GsmAlphabet.encode(known), StandardCharsets.ISO_8859_1));
            }
        });
        return line.toString();
    }

    /** A USSD text in this set; unchanged if it cannot be UCS2, or in HEX is not hexadecimal. */
    public String decodeUssd(String line) {
        if (this == HEX) {
            return decodeNumber(line);
        }
        try {
            return decode(line);
        } catch (IllegalArgumentException notHexadecimal) {
            return line;
        }
    }

    /** A number, or a code of the keys: unchanged, or in this set. */
    public String decodeNumber(String line) {
        try {
            String decoded = decode(line);
            return decoded.matches("\\+?[0-9*#]+") ? decoded : line;
        } catch (IllegalArgumentException notHexadecimal) {
            return line;
        }
    }
}
