package simgsm.smpp;

import java.util.ArrayList;
import java.util.List;
import simgsm.octets.OctetReader;
import simgsm.octets.OctetString;

/** Reads one PDU; if it is too short or a field too long, the violation has the status for the answer. */
final class SmppReader extends OctetReader<SmppViolation> implements SmppFields {
    /** Tag and length, two octets each (5.3.1). */
    private static final int TLV_HEADER = 4;

    SmppReader(byte[] octets, int from, int to) {
        super(octets, from, to, text -> new SmppViolation(SmppStatus.INVALID_COMMAND_LENGTH, text));
    }

    @Override
    public int octet(String field, int ignored) throws SmppViolation {
        return octet(field);
    }

    @Override
    public int octet(String field, int ignored, int most, int status) throws SmppViolation {
        int value = octet(field);
        if (value > most) {
            throw new SmppViolation(status, field + " " + value + ", expected 0 to " + most);
        }
        return value;
    }

    @Override
    public int fourOctets(String field, int ignored) throws SmppViolation {
        return (int) fourOctets(field);
    }

    @Override
    public String text(String field, int most, int status, String ignored) throws SmppViolation {
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

    @Override
    public OctetString shortMessage(OctetString ignored) throws SmppViolation {
        int length = octet("sm_length");
        if (length > SmppMessage.MAX_SHORT_MESSAGE) {
            throw new SmppViolation(SmppStatus.INVALID_MESSAGE_LENGTH, "sm_length " + length + " is over 254");
        }
        return string(length, "short_message", SmppStatus.INVALID_MESSAGE_LENGTH);
    }

    @Override
    public List<Tlv> parameters(List<Tlv> ignored) throws SmppViolation {
        List<Tlv> found = new ArrayList<>(2);
        while (hasMore()) {
            require(TLV_HEADER, "an optional parameter", SmppStatus.INVALID_OPTIONAL_PART);
            int tag = twoOctets("tag");
            int length = twoOctets("length");
            found.add(new Tlv(tag, string(length, "parameter " + tag, SmppStatus.INVALID_PARAMETER_LENGTH)));
        }
        return found;
    }

    /** True if further mandatory fields follow; peers omit the body of a response, especially in refusals. */
    boolean hasBody() {
        return hasMore();
    }

    private OctetString string(int count, String field, int status) throws SmppViolation {
        require(count, field, status);
        return string(count, field);
    }

    /** @param status the answer if fewer octets are left */
    private void require(int count, String field, int status) throws SmppViolation {
        if (count > remaining()) {
            throw new SmppViolation(
                    status, field + " needs " + count + " octets, " + remaining() + " are left in the PDU");
        }
    }
}
