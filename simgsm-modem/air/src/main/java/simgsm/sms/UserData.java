package simgsm.sms;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import simgsm.octets.Bounds;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.octets.Octets;
import simgsm.octets.Septets;

/**
 * The user data of one part. The octets are kept, so that a centre forwards them unchanged.
 * <pre>
 *   octets:  [ header length | header ]  [ fill bits ]  text
 * </pre>
 *
 * @param hasHeader TP-UDHI: the octets begin with a header
 * @param length TP-UDL: in septets, header included, for GSM 7-bit; else in octets
 */
public record UserData(boolean hasHeader, DataCodingScheme coding, int length, OctetString octets) {
    public static final int MAX_OCTETS = 140;
    public static final int MAX_SEPTETS = 160;

    public UserData {
        boolean septets = coding.alphabet() == Alphabet.GSM_7BIT;
        int most = septets ? MAX_SEPTETS : MAX_OCTETS;
        Bounds.check("user data length", length, 0, most);
        octets.requireLength("user data", octetCount(coding, length));
        if (hasHeader && (octets.length() == 0 || headerOctets(octets) > octets.length())) {
            throw new IllegalArgumentException("a user data header longer than the user data");
        }
    }

    /** Octets of user data with this TP-UDL. */
    static int octetCount(DataCodingScheme coding, int length) {
        return coding.alphabet() == Alphabet.GSM_7BIT ? Septets.octetCount(length, 0) : length;
    }

    /** A message of one part; IllegalArgumentException if the text does not fit. */
    public static UserData of(String text) {
        return of(text, Alphabet.of(text), new byte[0]);
    }

    /** One part with a header, its own length first, or without one if the array is empty. */
    static UserData of(String text, Alphabet alphabet, byte[] header) {
        boolean hasHeader = header.length > 0;
        DataCodingScheme coding = DataCodingScheme.of(alphabet);
        OctetWriter out = new OctetWriter().bytes(header);
        if (alphabet == Alphabet.GSM_7BIT) {
            byte[] codes = GsmAlphabet.encode(text);
            int headerSeptets = headerSeptets(header.length);
            out.bytes(Septets.pack(codes, headerSeptets * 7 - header.length * 8));
            return new UserData(hasHeader, coding, headerSeptets + codes.length, out.toOctetString());
        }
        out.bytes(Ucs2.encode(text));
        return new UserData(hasHeader, coding, out.length(), out.toOctetString());
    }

    /** Septets of a header with its fill bits. */
    private static int headerSeptets(int headerOctets) {
        return (headerOctets * 8 + 6) / 7;
    }

    /** The place of this part in its message; empty for a message of one part or an invalid header. */
    public Optional<Concatenation> concatenation() {
        return hasHeader ? UserDataHeader.concatenation(octets) : Optional.empty();
    }

    /** The text; for {@link Alphabet#OCTETS} one ISO 8859-1 character per octet. */
    public String text() {
        byte[] all = octets.toArray();
        int header = headerLength();
        return switch (coding.alphabet()) {
            case GSM_7BIT -> {
                int headerSeptets = headerSeptets(header);
                yield GsmAlphabet.decode(unpack(all, headerSeptets * 7, Math.max(0, length - headerSeptets)));
            }
            case UCS2 -> Ucs2.decode(all, header);
            case OCTETS -> new String(all, header, all.length - header, StandardCharsets.ISO_8859_1);
        };
    }

    /**
     * The text shown to a user: {@link #text}, but {@code 0x} and hexadecimal digits for octets that are not
     * printable.
     */
    public String shownText() {
        boolean isBinary =
                coding.alphabet() == Alphabet.OCTETS && !text().chars().allMatch(UserData::isPrintable);
        return isBinary ? "0x" + body() : text();
    }

    private static boolean isPrintable(int c) {
        return c >= ' ' && c < 0x7f || c >= 0xa0 || c == '\n' || c == '\r';
    }

    /** The octets after the header, for {@link Alphabet#OCTETS} and {@link Alphabet#UCS2}. */
    public OctetString body() {
        byte[] all = octets.toArray();
        return OctetString.of(Octets.range(all, headerLength(), all.length));
    }

    private int headerLength() {
        return hasHeader ? headerOctets(octets) : 0;
    }

    private static int headerOctets(OctetString octets) {
        return octets.octet(0) + 1;
    }

    private static byte[] unpack(byte[] octets, int bits, int count) {
        byte[] text = Octets.range(octets, Math.min(octets.length, bits / 8), octets.length);
        return Septets.unpack(text, count, bits % 8);
    }
}
