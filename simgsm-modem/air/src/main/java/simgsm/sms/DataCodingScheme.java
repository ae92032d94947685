package simgsm.sms;

import java.util.OptionalInt;
import simgsm.octets.Bounds;

/** TP-DCS: alphabet and class of a message (TS 23.038, 4). */
public record DataCodingScheme(int octet) {
    public static final DataCodingScheme GSM_7BIT = new DataCodingScheme(0x00);
    public static final DataCodingScheme OCTETS = new DataCodingScheme(0x04);
    public static final DataCodingScheme UCS2 = new DataCodingScheme(0x08);

    private static final int COMPRESSED = 0x20;
    private static final int HAS_CLASS = 0x10;

    public DataCodingScheme {
        Bounds.checkOctet("data coding scheme", octet);
    }

    /** The scheme of an alphabet, without a class. */
    public static DataCodingScheme of(Alphabet alphabet) {
        return alphabet == Alphabet.GSM_7BIT ? GSM_7BIT : alphabet == Alphabet.UCS2 ? UCS2 : OCTETS;
    }

    /** The alphabet; for reserved codings GSM 7-bit, as in the standard, for compressed text octets. */
    public Alphabet alphabet() {
        int group = octet >> 4;
        if (isGeneral()) {
            return (octet & COMPRESSED) != 0 ? Alphabet.OCTETS : general(octet >> 2 & 0x03);
        }
        if (group == 0x0f) {
            return (octet & 0x04) != 0 ? Alphabet.OCTETS : Alphabet.GSM_7BIT;
        }
        return group == 0x0e ? Alphabet.UCS2 : Alphabet.GSM_7BIT;
    }

    /** 0 for immediate display to 3; empty if the message has no class. */
    public OptionalInt messageClass() {
        boolean hasClass = isGeneral() ? (octet & HAS_CLASS) != 0 : octet >> 4 == 0x0f;
        return hasClass ? OptionalInt.of(octet & 0x03) : OptionalInt.empty();
    }

    private boolean isGeneral() {
        return octet < 0x80;
    }

    private static Alphabet general(int code) {
        return code == 1 ? Alphabet.OCTETS : code == 2 ? Alphabet.UCS2 : Alphabet.GSM_7BIT;
    }
}
