package simgsm.ss;

import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * One element of BER (X.690) with a tag of one octet and a definite length, sufficient for TS 24.080.
 *
 * @param content the octets after tag and length
 */
record BerElement(int tag, OctetString content) {
    static final int INTEGER = 0x02;
    static final int OCTET_STRING = 0x04;
    static final int NULL = 0x05;
    static final int SEQUENCE = 0x30;

    private static final int LONG_LENGTH = 0x80;
    private static final int LENGTH_IN_ONE_OCTET = 0x81;

    /** Appends an element of up to 255 octets. */
    static OctetWriter write(OctetWriter out, int tag, OctetString content) {
        out.octet(tag);
        if (content.length() >= LONG_LENGTH) {
            out.octet(LENGTH_IN_ONE_OCTET);
        }
        return out.octet(content.length()).string(content);
    }

    /** Appends an element of one octet. */
    static OctetWriter write(OctetWriter out, int tag, int octet) {
        return out.octet(tag).octet(1).octet(octet);
    }

    static BerElement read(MessageReader in, String what) throws ProtocolViolation {
        int tag = in.octet("tag of " + what);
        int length = in.octet("length of " + what);
        if (length == LENGTH_IN_ONE_OCTET) {
            length = in.octet("length of " + what);
        } else if (length >= LONG_LENGTH) {
            throw ProtocolViolation.invalid("the length of " + what + " is not definite and below 256");
        }
        return new BerElement(tag, in.part(length, what).rest());
    }

    /** The index of the content of the element that begins at an index. */
    static int content(OctetString octets, int at) {
        return at + (octets.octet(at + 1) == LENGTH_IN_ONE_OCTET ? 3 : 2);
    }

    /** The next element, which must have this tag. */
    static OctetString read(MessageReader in, int tag, String what) throws ProtocolViolation {
        BerElement element = read(in, what);
        if (element.tag != tag) {
            throw ProtocolViolation.invalid(
                    String.format("%s has tag 0x%02x, 0x%02x was expected", what, element.tag, tag));
        }
        return element.content;
    }

    /** The value of an element of one octet. */
    int octet(String what) throws ProtocolViolation {
        if (content.length() != 1) {
            throw ProtocolViolation.invalid(what + " has " + content.length() + " octets, 1 was expected");
        }
        return content.octet(0);
    }
}
