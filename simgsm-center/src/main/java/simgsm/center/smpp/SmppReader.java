package simgsm.center.smpp;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simgsm.octets.OctetString;

/** Reads the octets of one PDU in order; the end comes as {@link SmppViolation}, never as an index error. */
final class SmppReader {
    private static final int TLV_HEADER = 4;

    private final byte[] octets;
    private final int end;
    private int position;

    SmppReader(byte[] octets, int from, int to) {
        this.octets = octets;
        this.position = from;
        this.end = to;
    }

    boolean hasMore() {
        return position < end;
    }

    int octet(String field) throws SmppViolation {
        require(1, field, SmppStatus.INVALID_COMMAND_LENGTH);
        return octets[position++] & 0xff;
    }

    int fourOctets(String field) throws SmppViolation {
        require(4, field, SmppStatus.INVALID_COMMAND_LENGTH);
        int value = 0;
        for (int i = 0; i < 4; i++) {
            value = value << 8 | octets[position++] & 0xff;
        }
        return value;
    }

    /**
     * A text that ends with a zero octet.
     *
     * @param most octets, with the zero
     * @param status the answer to a longer one
     */
    String text(int most, String field, int status) throws SmppViolation {
        int limit = Math.min(end, position + most);
        for (int i = position; i < limit; i++) {
            if (octets[i] == 0) {
                String text =
                        i == position ? "" : new String(octets, position, i - position, StandardCharsets.ISO_8859_1);
                position = i + 1;
                return text;
            }
        }
        if (limit < position + most) {
            throw new SmppViolation(SmppStatus.INVALID_COMMAND_LENGTH, field + " does not end within the PDU");
        }
        throw new SmppViolation(status, field + " does not end within " + most + " octets");
    }

    OctetString string(int count, String field, int status) throws SmppViolation {
        require(count, field, status);
        position += count;
        return OctetString.of(Arrays.copyOfRange(octets, position - count, position));
    }

    /** All that is left, as optional parameters. */
    List<Tlv> parameters() throws SmppViolation {
        if (!hasMore()) {
            return List.of();
        }
        List<Tlv> found = new ArrayList<>(2);
        while (hasMore()) {
            require(TLV_HEADER, "an optional parameter", SmppStatus.INVALID_OPTIONAL_PART);
            int tag = octet("tag") << 8 | octet("tag");
            int length = octet("length") << 8 | octet("length");
            found.add(new Tlv(tag, string(length, "parameter " + tag, SmppStatus.INVALID_PARAMETER_LENGTH)));
        }
        return found;
    }

    private void require(int count, String field, int status) throws SmppViolation {
        if (count > end - position) {
            throw new SmppViolation(
                    status, field + " needs " + count + " octets, " + (end - position) + " are left in the PDU");
        }
    }
}
