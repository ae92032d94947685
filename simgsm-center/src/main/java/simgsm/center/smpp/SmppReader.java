package simgsm.center.smpp;

import java.util.ArrayList;
import java.util.List;
import simgsm.octets.OctetReader;
import simgsm.octets.OctetString;

/** Reads one PDU; where it is too short or a field too long, the violation has the status that answers it. */
final class SmppReader extends OctetReader<SmppViolation> {
    /** Tag and length, two octets each (5.3.1). */
    private static final int TLV_HEADER = 4;

    SmppReader(byte[] octets, int from, int to) {
        super(octets, from, to, text -> new SmppViolation(SmppStatus.INVALID_COMMAND_LENGTH, text));
    }

    /** Four octets of the header, as the bits of an int. */
    int word(String field) throws SmppViolation {
        return (int) fourOctets(field);
    }

    /**
     * A text that ends with a zero octet.
     *
     * @param most octets, with the zero
     * @param status the answer to a longer one
     */
    String text(int most, String field, int status) throws SmppViolation {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < most; i++) {
            if (!hasMore()) {
                throw new SmppViolation(SmppStatus.INVALID_COMMAND_LENGTH, field + " does not end within the PDU");
            }
            int octet = octet(field);
            if (octet == 0) {
                return text.toString();
            }
            text.append((char) octet);
        }
        throw new SmppViolation(status, field + " does not end within " + most + " octets");
    }

    /** @param status the answer if fewer octets are left */
    OctetString string(int count, String field, int status) throws SmppViolation {
        require(count, field, status);
        return string(count, field);
    }

    /** All that is left, as optional parameters. */
    List<Tlv> parameters() throws SmppViolation {
        List<Tlv> found = new ArrayList<>(2);
        while (hasMore()) {
            require(TLV_HEADER, "an optional parameter", SmppStatus.INVALID_OPTIONAL_PART);
            int tag = twoOctets("tag");
            int length = twoOctets("length");
            found.add(new Tlv(tag, string(length, "parameter " + tag, SmppStatus.INVALID_PARAMETER_LENGTH)));
        }
        return found;
    }

    private void require(int count, String field, int status) throws SmppViolation {
        if (count > remaining()) {
            throw new SmppViolation(
                    status, field + " needs " + count + " octets, " + remaining() + " are left in the PDU");
        }
    }
}
