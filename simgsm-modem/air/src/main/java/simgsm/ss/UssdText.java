package simgsm.ss;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.octets.Septets;
import simgsm.sms.BroadcastCoding;
import simgsm.sms.GsmAlphabet;
import simgsm.sms.Ucs2;

/**
 * A text of USSD (TS 24.080, 4.4.3.11: USSD-Arg and USSD-Res): its coding, as of cell broadcast (TS 23.038, 5), and
 * its octets.
 * <pre>
 *   30 length   04 01 coding   04 length octets
 * </pre>
 *
 * @param octets 1 to 160
 */
public record UssdText(BroadcastCoding coding, OctetString octets) {
    public static final int MAX_OCTETS = 160;
    /** Characters of the GSM alphabet, those of its extension counted twice. */
    public static final int MAX_SEPTETS = MAX_OCTETS * 8 / 7;

    private static final byte CARRIAGE_RETURN = 0x0d;

    public UssdText {
        octets.requireLength("a USSD text", 1, MAX_OCTETS);
    }

    /** @throws IllegalArgumentException for an empty text, and for one that is too long */
    public static UssdText of(String text) {
        if (!GsmAlphabet.encodes(text)) {
            return new UssdText(BroadcastCoding.UCS2, OctetString.of(Ucs2.encode(text)));
        }
        return new UssdText(BroadcastCoding.GSM_7BIT, OctetString.of(pack(GsmAlphabet.encode(text))));
    }

    /** True if {@link #of} accepts the text. */
    public static boolean fits(String text) {
        if (!GsmAlphabet.encodes(text)) {
            return 2 * text.length() <= MAX_OCTETS;
        }
        return !text.isEmpty() && pack(GsmAlphabet.encode(text)).length <= MAX_OCTETS;
    }

    /**
     * Seven spare bits are filled with a carriage return, because zeros would be an "@"; a text that ends with a
     * carriage return on an octet's edge gets a second one (TS 23.038, 6.1.2.3.1).
     */
    private static byte[] pack(byte[] codes) {
        boolean leavesSevenBits = codes.length % 8 == 7;
        boolean endsOnOctet = codes.length > 0 && codes.length % 8 == 0;
        if (leavesSevenBits || endsOnOctet && codes[codes.length - 1] == CARRIAGE_RETURN) {
            codes = Arrays.copyOf(codes, codes.length + 1);
            codes[codes.length - 1] = CARRIAGE_RETURN;
        }
        return Septets.pack(codes, 0);
    }

    /** The text; of a coding that is no text, one ISO 8859-1 character per octet. */
    public String text() {
        byte[] all = octets.toArray();
        return switch (coding.alphabet()) {
            case GSM_7BIT -> GsmAlphabet.decode(unpack(all));
            case UCS2 -> Ucs2.decode(all, 0);
            case OCTETS -> new String(all, StandardCharsets.ISO_8859_1);
        };
    }

    private static byte[] unpack(byte[] all) {
        byte[] codes = Septets.unpack(all, all.length * 8 / 7, 0);
        boolean isPadded = codes.length % 8 == 0 && codes[codes.length - 1] == CARRIAGE_RETURN;
        return isPadded ? Arrays.copyOf(codes, codes.length - 1) : codes;
    }

    /** The parameter of an operation or result. */
    public OctetString encode() {
        OctetWriter body = new OctetWriter();
        BerElement.write(body, BerElement.OCTET_STRING, coding.octet());
        BerElement.write(body, BerElement.OCTET_STRING, octets);
        return BerElement.write(new OctetWriter(), BerElement.SEQUENCE, body.toOctetString())
                .toOctetString();
    }

    /** Elements after the text, such as an alerting pattern, are ignored. */
    public static UssdText decode(OctetString parameter) throws ProtocolViolation {
        MessageReader body = new MessageReader(
                BerElement.read(new MessageReader(parameter), BerElement.SEQUENCE, "the USSD argument"));
        OctetString coding = BerElement.read(body, BerElement.OCTET_STRING, "the data coding scheme");
        OctetString text = BerElement.read(body, BerElement.OCTET_STRING, "the USSD string");
        if (coding.length() != 1 || text.length() == 0 || text.length() > MAX_OCTETS) {
            throw ProtocolViolation.invalid("a USSD text of " + text.length() + " octets with a coding of "
                    + coding.length() + ", 1 to " + MAX_OCTETS + " and 1 were expected");
        }
        return new UssdText(new BroadcastCoding(coding.octet(0)), text);
    }
}
