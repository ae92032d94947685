package simgsm.trace;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText.Field;

/**
 * The octets that each field of a message stands in: those that change the field's value. They are found by reading the
 * message again with each hexadecimal digit replaced by all others, so every message that can be read has them, and no codec has to tell positions.
 * Identifiers and lengths, without which the message cannot be read, belong to the value that follows them.
 */
public final class FieldOctets {
    /** Name of the field of a message that cannot be read. */
    public static final String WRONG = "wrong";

    /** Discriminator and message type of layer 3 and RSL. */
    private static final int HEADER_LENGTH = 2;

    /** The ways in which a hexadecimal digit of an octet can be another one. */
    private static final int MASKS = 15;

    private final List<BitSet> byField = new ArrayList<>();

    /**
     * Finds the octets.
     *
     * @param message as the reader returns it for its octets
     * @param reader reads octets of the same length; it tells unreadable ones by a field named {@link #WRONG}
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

    /** The fields that change with this octet: those of the changes that change the fewest. */
    private static BitSet fieldsOf(
            int octet, byte[] octets, MessageText message, Function<OctetString, MessageText> reader) {
        BitSet found = new BitSet();
        int fewest = Integer.MAX_VALUE;
        for (int digit = 0; digit < 2 * MASKS; digit++) {
            byte[] changed = octets.clone();
            changed[octet] ^= (byte) (digit < MASKS ? digit + 1 : digit - MASKS + 1 << 4);
            MessageText other = reader.apply(OctetString.of(changed));
            if (isReadable(other) && (octet >= HEADER_LENGTH || other.name().equals(message.name()))) {
                BitSet fields = changed(message.fields(), other.fields());
                int count = fields.cardinality();
                if (count > 0 && count < fewest) {
                    fewest = count;
                    found.clear();
                }
                if (count == fewest) {
                    found.or(fields);
                }
            }
        }
        return found;
    }

    /** The places of fields whose value another reading has not. */
    private static BitSet changed(List<Field> fields, List<Field> others) {
        Map<String, List<String>> values = new HashMap<>();
        others.forEach(field ->
                values.computeIfAbsent(field.name(), name -> new ArrayList<>()).add(field.value()));
        BitSet changed = new BitSet();
        for (int i = 0; i < fields.size(); i++) {
            List<String> same = values.getOrDefault(fields.get(i).name(), List.of());
            if (same.isEmpty() || !same.remove(0).equals(fields.get(i).value())) {
                changed.set(i);
            }
        }
        return changed;
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
