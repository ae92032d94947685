package simgsm.trace;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.function.Function;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText.Field;

/**
 * The octets that each field of a message stands in: those that change the field's value. They are found by reading the
 * message again with other octets, so every message that can be read has them, and no codec has to tell positions.
 * Identifiers and lengths, without which the message has other fields or none, belong to the value that follows them.
 */
public final class FieldOctets {
    /** Name of the field of a message that cannot be read. */
    public static final String WRONG = "wrong";

    /** Discriminator and message type of layer 3 and RSL. */
    private static final int HEADER_LENGTH = 2;

    private static final int DIGIT_BITS = 4;
    /** The ways in which a hexadecimal digit can be another one; those of one bit come first. */
    private static final int[] MASKS = {1, 2, 4, 8, 3, 5, 6, 7, 9, 10, 11, 12, 13, 14, 15};
    /** A length that changes more fields than a text and its length moves all that follows. */
    private static final int MOST_FIELDS = 2;

    private final List<BitSet> byField = new ArrayList<>();

    /**
     * Finds the octets.
     *
     * @param message as the reader returns it for its octets
     * @param reader reads octets of the same length; it marks unreadable ones by a field named {@link #WRONG}
     */
    public FieldOctets(MessageText message, Function<OctetString, MessageText> reader) {
        message.fields().forEach(field -> byField.add(new BitSet()));
        byte[] octets = message.octets().toArray();
        if (isReadable(message)) {
            List<BitSet> byOctet = new ArrayList<>();
            for (int octet = 0; octet < octets.length; octet++) {
                byOctet.add(fieldsOf(octet, octets, message, reader));
            }
            keepLongestRuns(byOctet, message.fields().size());
            addFraming(byOctet);
            for (int octet = 0; octet < octets.length; octet++) {
                int at = octet;
                byOctet.get(octet).stream().forEach(field -> byField.get(field).set(at));
            }
        }
    }

    /** The octets of a field, counted from 0. @param field its place among the message's fields */
    public BitSet of(int field) {
        return (BitSet) byField.get(field).clone();
    }

    /** The field with the fewest octets among those that stand in this one; -1 for none. */
    public int at(int octet) {
        int found = -1;
        for (int field = 0; field < byField.size(); field++) {
            BitSet octets = byField.get(field);
            if (octets.get(octet)
                    && (found < 0 || octets.cardinality() < byField.get(found).cardinality())) {
                found = field;
            }
        }
        return found;
    }

    private static boolean isReadable(MessageText message) {
        return message.fields().stream().noneMatch(field -> field.name().equals(WRONG));
    }

    /** The fields that change with one of this octet's hexadecimal digits: of all changes, those with the fewest fields. */
    private static BitSet fieldsOf(
            int octet, byte[] octets, MessageText message, Function<OctetString, MessageText> reader) {
        BitSet found = new BitSet();
        int fewest = MOST_FIELDS;
        for (int shift = 0; shift < Byte.SIZE; shift += DIGIT_BITS) {
            boolean hasDigit = false;
            for (int mask : MASKS) {
                if (Integer.bitCount(mask) > 1 && hasDigit) {
                    break;
                }
                byte[] other = octets.clone();
                other[octet] ^= (byte) (mask << shift);
                BitSet fields = changed(message, reader.apply(OctetString.of(other)), octet < HEADER_LENGTH);
                int count = fields.cardinality();
                if (count > 0 && count < fewest) {
                    fewest = count;
                    found.clear();
                }
                if (count == fewest) {
                    found.or(fields);
                    hasDigit = true;
                }
            }
        }
        return found;
    }

    /** The places of the fields whose value differs; none if the other message cannot be read or has other fields. */
    private static BitSet changed(MessageText message, MessageText other, boolean isHeader) {
        BitSet changed = new BitSet();
        boolean isSame = isReadable(other)
                && message.fields().size() == other.fields().size()
                && (!isHeader || message.name().equals(other.name()));
        for (int i = 0; isSame && i < message.fields().size(); i++) {
            Field field = message.fields().get(i);
            isSame = field.name().equals(other.fields().get(i).name());
            changed.set(i, !field.value().equals(other.fields().get(i).value()));
        }
        return isSame ? changed : new BitSet();
    }

    /** A field is a row of octets: lengths before it and the coding of a text change it from elsewhere. */
    private static void keepLongestRuns(List<BitSet> byOctet, int fields) {
        for (int field = 0; field < fields; field++) {
            int longestAt = 0;
            int longest = 0;
            for (int start = 0; start < byOctet.size(); start++) {
                int end = start;
                while (end < byOctet.size() && byOctet.get(end).get(field)) {
                    end++;
                }
                if (end - start > longest) {
                    longestAt = start;
                    longest = end - start;
                }
            }
            for (int octet = 0; octet < byOctet.size(); octet++) {
                if (octet < longestAt || octet >= longestAt + longest) {
                    byOctet.get(octet).clear(field);
                }
            }
        }
    }

    /** Octets behind the header that belong to no field join the next that does; at the end, the one before. */
    private static void addFraming(List<BitSet> byOctet) {
        BitSet next = new BitSet();
        for (int octet = byOctet.size() - 1; octet >= HEADER_LENGTH; octet--) {
            if (byOctet.get(octet).isEmpty()) {
                byOctet.get(octet).or(next);
            } else {
                next = byOctet.get(octet);
            }
        }
        BitSet before = new BitSet();
        for (int octet = HEADER_LENGTH; octet < byOctet.size(); octet++) {
            if (byOctet.get(octet).isEmpty()) {
                byOctet.get(octet).or(before);
            } else {
                before = byOctet.get(octet);
            }
        }
    }
}
