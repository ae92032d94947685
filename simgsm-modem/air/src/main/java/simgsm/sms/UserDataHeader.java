package simgsm.sms;

import java.util.Optional;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

/** The user data header before the text: elements of identifier, length and value (TS 23.040, 9.2.3.24). */
final class UserDataHeader {
    private static final int CONCATENATION_8_BIT = 0x00;
    private static final int CONCATENATION_16_BIT = 0x08;

    private UserDataHeader() {}

    /** The header of one part of several, its own length first: 05 00 03 reference total part. */
    static byte[] of(Concatenation concatenation) {
        return new byte[] {
            5,
            CONCATENATION_8_BIT,
            3,
            (byte) concatenation.reference(),
            (byte) concatenation.total(),
            (byte) concatenation.part()
        };
    }

    /** The last valid concatenation element; invalid ones are ignored (TS 23.040, 9.2.3.24.1). */
    static Optional<Concatenation> concatenation(OctetString userData) {
        Optional<Concatenation> found = Optional.empty();
        try {
            MessageReader header = new MessageReader(userData).lengthAndValue("user data header");
            while (header.hasMore()) {
                int identifier = header.octet("header element");
                MessageReader value = header.lengthAndValue("header element");
                Optional<Concatenation> element = element(identifier, value);
                found = element.isPresent() ? element : found;
            }
        } catch (ProtocolViolation cut) {
            return found;
        }
        return found;
    }

    private static Optional<Concatenation> element(int identifier, MessageReader value) throws ProtocolViolation {
        int reference;
        if (identifier == CONCATENATION_8_BIT && value.remaining() == 3) {
            reference = value.octet("reference");
        } else if (identifier == CONCATENATION_16_BIT && value.remaining() == 4) {
            reference = value.twoOctets("reference");
        } else {
            return Optional.empty();
        }
        int total = value.octet("number of parts");
        int part = value.octet("part");
        return part < 1 || part > total ? Optional.empty() : Optional.of(new Concatenation(reference, total, part));
    }
}
