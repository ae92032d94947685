package simgsm.sms;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import simgsm.air.Septets;
import simgsm.octets.OctetString;

/**
 * One user part as it travels: kept as octets, so that a centre hands on exactly what it was given.
 *
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
        if (length < 0 || length > most) {
            throw new IllegalArgumentException("a user data length of " + length + " is not 0 to " + most);
        }
        int expected = octetCount(coding, length);
        if (octets.length() != expected) {
            throw new IllegalArgumentException(
                    "user data of " + octets.length() + " octets, its length says " + expected);
        }
        if (hasHeader && (octets.length() == 0 || headerOctets(octets) > octets.length())) {
            throw new IllegalArgumentException("a user data header longer than the user data");
        }
    }

    /** How many octets a user part of this TP-UDL has. */
    static int octetCount(DataCodingScheme coding, int length) {
        return coding.alphabet() == Alphabet.GSM_7BIT ? Septets.octetCount(length, 0) : length;
    }

    /** A message of one part; IllegalArgumentException if the text does not fit. */
    public static UserData of(String text) {
        return UserPartWriter.write(text, Alphabet.of(text), new byte[0]);
    }

    /** Which part of which message this is; empty for a message of one part or a header that makes no sense. */
    public Optional<Concatenation> concatenation() {
        return hasHeader ? UserDataHeader.concatenation(octets) : Optional.empty();
    }

    /** The text; for {@link Alphabet#OCTETS} one Latin-1 character an octet. */
    public String text() {
        byte[] all = octets.toArray();
        int header = headerLength();
        switch (coding.alphabet()) {
            case GSM_7BIT:
                int headerSeptets = (header * 8 + 6) / 7;
                int fillBits = headerSeptets * 7;
                byte[] codes = unpackBehind(all, fillBits, Math.max(0, length - headerSeptets));
                return GsmAlphabet.decode(codes);
            case UCS2:
                return Ucs2.decode(all, header);
            default:
                return new String(all, header, all.length - header, StandardCharsets.ISO_8859_1);
        }
    }

    /** What follows the header, as octets; of use for {@link Alphabet#OCTETS} and {@link Alphabet#UCS2}. */
    public OctetString body() {
        byte[] all = octets.toArray();
        return OctetString.of(Arrays.copyOfRange(all, headerLength(), all.length));
    }

    private int headerLength() {
        return hasHeader ? headerOctets(octets) : 0;
    }

    private static int headerOctets(OctetString octets) {
        return (octets.toArray()[0] & 0xff) + 1;
    }

    private static byte[] unpackBehind(byte[] octets, int bits, int count) {
        byte[] text = Arrays.copyOfRange(octets, Math.min(octets.length, bits / 8), octets.length);
        return Septets.unpack(text, count, bits % 8);
    }
}
