package simgsm.rr;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

/** A set of ARFCNs in 16 octets (TS 44.018, 10.5.2.13): as bit map 0 up to ARFCN 124, else as variable bit map. */
public final class FrequencyList {
    private static final int OCTETS = 16;
    private static final int MOST_OF_MAP_0 = 124;
    private static final int FORMAT_MASK = 0xce;
    private static final int VARIABLE = 0x8e;
    /** Frequencies that a variable bit map encodes, after the first. */
    private static final int VARIABLE_SPAN = 111;

    private static final int ARFCNS = 1024;

    /** The order of frequencies in measurement reports: ascending, an ARFCN of 0 last. */
    public static final Comparator<Integer> ORDER = Comparator.comparingInt(arfcn -> arfcn == 0 ? ARFCNS : arfcn);

    private FrequencyList() {}

    /**
     * The octets of the list.
     *
     * @throws IllegalArgumentException if the frequencies are too far apart for either form
     */
    public static OctetString encode(Collection<Integer> arfcns) {
        byte[] octets = new byte[OCTETS];
        SortedSet<Integer> sorted = new TreeSet<>(arfcns);
        if (sorted.isEmpty() || sorted.first() >= 1 && sorted.last() <= MOST_OF_MAP_0) {
            sorted.forEach(arfcn -> set(octets, arfcn - 1));
        } else {
            int origin = sorted.first();
            if (sorted.last() - origin > VARIABLE_SPAN) {
                throw new IllegalArgumentException("the neighbours' ARFCNs " + origin + " to " + sorted.last()
                        + " are more than " + VARIABLE_SPAN + " apart");
            }
            octets[0] = (byte) (VARIABLE | origin >> 9);
            octets[1] = (byte) (origin >> 1);
            octets[2] = (byte) (origin << 7);
            sorted.tailSet(origin + 1).forEach(arfcn -> set(octets, VARIABLE_SPAN - (arfcn - origin)));
        }
        return OctetString.of(octets);
    }

    /** Sets the bit at a place, counted from the last octet's lowest bit. */
    private static void set(byte[] octets, int place) {
        octets[OCTETS - 1 - place / 8] |= (byte) (1 << place % 8);
    }

    /** The frequencies, in {@link #ORDER}. */
    public static List<Integer> decode(OctetString octets) throws ProtocolViolation {
        octets.requireLength("frequency list", OCTETS);
        SortedSet<Integer> arfcns = new TreeSet<>(ORDER);
        int first = octets.octet(0);
        if ((first & 0xc0) == 0) {
            for (int place = 0; place < MOST_OF_MAP_0; place++) {
                if (isSet(octets, place)) {
                    arfcns.add(place + 1);
                }
            }
        } else if ((first & FORMAT_MASK) == VARIABLE) {
            int origin = (first & 1) << 9 | octets.octet(1) << 1 | octets.octet(2) >> 7;
            arfcns.add(origin);
            for (int place = 0; place < VARIABLE_SPAN; place++) {
                if (isSet(octets, place)) {
                    arfcns.add((origin + VARIABLE_SPAN - place) % ARFCNS);
                }
            }
        } else {
            throw ProtocolViolation.invalid(
                    String.format("frequency list of format 0x%02x; bit map 0 or variable was expected", first));
        }
        return List.copyOf(arfcns);
    }

    private static boolean isSet(OctetString octets, int place) {
        return (octets.octet(OCTETS - 1 - place / 8) >> place % 8 & 1) != 0;
    }
}
