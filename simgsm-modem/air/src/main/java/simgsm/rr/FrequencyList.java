package simgsm.rr;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.IntUnaryOperator;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

/**
 * A set of ARFCNs in 16 octets (TS 44.018, 10.5.2.1b and 10.5.2.13) in any of six formats: bit map 0, range 1024, 512, 256
 * or 128, variable bit map.
 */
public final class FrequencyList {
    /** Maximum number of frequencies that any set of them has room for: that of the range 1024 format. */
    public static final int SURE = 16;

    private static final int OCTETS = 16;
    private static final int BITS = 8 * OCTETS;
    private static final int MOST_OF_MAP_0 = 124;
    /** The bits of an element's first octet that name the format; those between are used by neighbour cell lists. */
    private static final int FORMAT_MASK = 0x8e;

    private static final int RANGE_1024_MASK = 0x88;
    private static final int RANGE_1024 = 0x80;
    /** In range 1024: ARFCN 0 is a member. */
    private static final int WITH_ZERO = 0x04;

    private static final int VARIABLE = 0x8e;
    /** Frequencies that a variable bit map encodes, after the first. */
    private static final int VARIABLE_SPAN = 111;
    /** Place of the first bit after the format and, except in range 1024, the 10 bits of ORIG-ARFCN. */
    private static final int AFTER_ORIGIN = 17;

    private static final int AFTER_1024 = 6;
    private static final int ARFCNS = 1024;
    private static final int FIRST_BELOW_ZERO = 955;

    /** The order of frequencies in measurement reports: ascending, an ARFCN of 0 last. */
    public static final Comparator<Integer> ORDER = Comparator.comparingInt(arfcn -> arfcn == 0 ? ARFCNS : arfcn);

    /** The range formats, the most compact first. */
    private enum Range {
        RANGE_128(0x8c, 128),
        RANGE_256(0x8a, 256),
        RANGE_512(0x88, 512);

        private final int format;
        private final int size;

        Range(int format, int size) {
            this.format = format;
            this.size = size;
        }
    }

    private FrequencyList() {}

    /**
     * The octets of the list, in the first format with room for it: bit map 0, variable bit map, range 128, 256, 512, 1024.
     *
     * @throws IllegalArgumentException if no format has room for the frequencies
     */
    public static OctetString encode(Collection<Integer> arfcns) {
        return find(arfcns)
                .orElseThrow(() -> new IllegalArgumentException("no frequency list has room for the " + arfcns.size()
                        + " ARFCNs " + new TreeSet<>(arfcns) + ", expected at most " + SURE
                        + " or less far apart"));
    }

    /** The octets of the list as {@link #encode}; empty if no format has room for it. */
    public static Optional<OctetString> find(Collection<Integer> arfcns) {
        SortedSet<Integer> sorted = new TreeSet<>(arfcns);
        byte[] octets = new byte[OCTETS];
        if (sorted.isEmpty() || sorted.first() >= 1 && sorted.last() <= MOST_OF_MAP_0) {
            sorted.forEach(arfcn -> write(octets, BITS - arfcn, 1, 1));
            return Optional.of(OctetString.of(octets));
        }
        SortedSet<Integer> inFrequency = new TreeSet<>(Comparator.comparingInt(FrequencyList::place));
        inFrequency.addAll(arfcns);
        int lowest = inFrequency.first();
        if (place(inFrequency.last()) - place(lowest) <= VARIABLE_SPAN) {
            begin(octets, VARIABLE, lowest);
            inFrequency
                    .tailSet(lowest + 1)
                    .forEach(arfcn -> write(octets, AFTER_ORIGIN - 1 + place(arfcn) - place(lowest), 1, 1));
            return Optional.of(OctetString.of(octets));
        }
        int origin = sorted.first();
        int span = sorted.last() - origin;
        for (Range range : Range.values()) {
            List<Integer> others = sorted.tailSet(origin + 1).stream()
                    .map(arfcn -> arfcn - origin - 1)
                    .toList();
            if (span < range.size && others.size() <= RangeTree.room(range.size, BITS - AFTER_ORIGIN)) {
                begin(octets, range.format, origin);
                writeTree(octets, AFTER_ORIGIN, range.size, others);
                return Optional.of(OctetString.of(octets));
            }
        }
        List<Integer> others =
                sorted.tailSet(1).stream().map(arfcn -> arfcn - 1).toList();
        if (others.size() > RangeTree.room(ARFCNS, BITS - AFTER_1024)) {
            return Optional.empty();
        }
        octets[0] = (byte) (RANGE_1024 | (origin == 0 ? WITH_ZERO : 0));
        writeTree(octets, AFTER_1024, ARFCNS, others);
        return Optional.of(OctetString.of(octets));
    }

    /** True if the list of these is encoded in range 128, 256, 512 or 1024. */
    public static boolean isRange(Collection<Integer> arfcns) {
        return find(arfcns)
                .map(octets -> octets.octet(0))
                .filter(first -> (first & RANGE_1024) != 0 && (first & FORMAT_MASK) != VARIABLE)
                .isPresent();
    }

    /** Channels of the extension of GSM 900, from ARFCN 955 on, are below ARFCN 0. */
    private static int place(int arfcn) {
        return arfcn >= FIRST_BELOW_ZERO ? arfcn - ARFCNS : arfcn;
    }

    private static void begin(byte[] octets, int format, int origin) {
        write(octets, 0, Byte.SIZE, format);
        write(octets, 7, 10, origin);
    }

    private static void writeTree(byte[] octets, int from, int size, List<Integer> offsets) {
        int at = from;
        int[] words = RangeTree.words(size, offsets);
        for (int i = 1; i < words.length; i++) {
            int width = RangeTree.width(size, i);
            write(octets, at, width, words[i]);
            at += width;
        }
    }

    /** Sets bits; the first octet's highest bit has place 0. */
    private static void write(byte[] octets, int from, int width, int value) {
        for (int i = 0; i < width; i++) {
            int bit = value >> width - 1 - i & 1;
            octets[(from + i) / Byte.SIZE] |= (byte) (bit << 7 - (from + i) % Byte.SIZE);
        }
    }

    private static int read(OctetString octets, int from, int width) {
        int value = 0;
        for (int at = from; at < from + width; at++) {
            value = value << 1 | octets.octet(at / Byte.SIZE) >> 7 - at % Byte.SIZE & 1;
        }
        return value;
    }

    /** The frequencies, in {@link #ORDER}. */
    public static List<Integer> decode(OctetString octets) throws ProtocolViolation {
        octets.requireLength("frequency list", OCTETS);
        SortedSet<Integer> arfcns = new TreeSet<>(ORDER);
        int first = octets.octet(0);
        int origin = read(octets, 7, 10);
        if ((first & RANGE_1024) == 0) {
            addMap(arfcns, octets, BITS - MOST_OF_MAP_0, arfcn -> MOST_OF_MAP_0 - arfcn);
        } else if ((first & RANGE_1024_MASK) == RANGE_1024) {
            if ((first & WITH_ZERO) != 0) {
                arfcns.add(0);
            }
            words(octets, AFTER_1024, ARFCNS).forEach(offset -> arfcns.add(offset + 1));
        } else {
            arfcns.add(origin);
            if ((first & FORMAT_MASK) == VARIABLE) {
                addMap(arfcns, octets, AFTER_ORIGIN, place -> (origin + 1 + place) % ARFCNS);
            } else {
                for (Range range : Range.values()) {
                    if ((first & FORMAT_MASK) == range.format) {
                        words(octets, AFTER_ORIGIN, range.size)
                                .forEach(offset -> arfcns.add((origin + 1 + offset) % ARFCNS));
                    }
                }
            }
        }
        return List.copyOf(arfcns);
    }

    private static void addMap(Collection<Integer> arfcns, OctetString octets, int from, IntUnaryOperator arfcnAt) {
        for (int at = from; at < BITS; at++) {
            if (read(octets, at, 1) == 1) {
                arfcns.add(arfcnAt.applyAsInt(at - from));
            }
        }
    }

    private static List<Integer> words(OctetString octets, int from, int size) {
        int room = RangeTree.room(size, BITS - from);
        int[] words = new int[room + 1];
        int at = from;
        for (int i = 1; i <= room; i++) {
            int width = RangeTree.width(size, i);
            words[i] = read(octets, at, width);
            at += width;
        }
        return new ArrayList<>(RangeTree.offsets(size, words));
    }
}
