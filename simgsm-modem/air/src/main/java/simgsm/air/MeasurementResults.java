package simgsm.air;

import java.util.ArrayList;
import java.util.List;
import simgsm.octets.Bounds;

/**
 * Measurements of a mobile on a dedicated channel in 480 ms (TS 44.018, 10.5.2.20). Levels are RXLEV, 0 to 63: the
 * level in dBm plus 110. Qualities are RXQUAL, 0 to 7.
 *
 * @param usesSecondList true if frequencies are indexed in the second neighbour list (BA-USED)
 * @param usesDtx true if the mobile transmitted only while its user spoke
 * @param isValid true if the values of the serving cell are valid
 * @param neighbours at most 6, the strongest first
 */
public record MeasurementResults(
        boolean usesSecondList,
        boolean usesDtx,
        boolean isValid,
        int fullLevel,
        int subLevel,
        int fullQuality,
        int subQuality,
        List<Neighbour> neighbours) {
    public static final int MOST_NEIGHBOURS = 6;

    /** Octets after the message type. */
    static final int LENGTH = 16;
    /** NO-NCELL-M: neighbour cell information is not available. */
    private static final int NOT_AVAILABLE = 7;

    private static final int BITS = 8 * LENGTH;

    /**
     * A neighbour cell.
     *
     * @param frequencyIndex index in the frequencies of SYSTEM INFORMATION 5, in ascending order of ARFCN, 0 to 31
     * @param identityCode BSIC, 0 to 63
     */
    public record Neighbour(int level, int frequencyIndex, int identityCode) {
        public Neighbour {
            Bounds.check("RXLEV", level, 0, 63);
            Bounds.check("BCCH frequency index", frequencyIndex, 0, 31);
            Bounds.check("BSIC", identityCode, 0, 63);
        }
    }

    public MeasurementResults {
        Bounds.check("RXLEV", fullLevel, 0, 63);
        Bounds.check("RXLEV", subLevel, 0, 63);
        Bounds.check("RXQUAL", fullQuality, 0, 7);
        Bounds.check("RXQUAL", subQuality, 0, 7);
        Bounds.check("number of neighbour cells", neighbours.size(), 0, MOST_NEIGHBOURS);
        neighbours = List.copyOf(neighbours);
    }

    /** Valid results of a mobile that transmits all the time. */
    public static MeasurementResults of(int level, int quality, List<Neighbour> neighbours) {
        return new MeasurementResults(false, false, true, level, level, quality, quality, neighbours);
    }

    /** As "RXLEV 50 quality 0, neighbour 0 BSIC 11: 30". */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("RXLEV " + fullLevel + " quality " + fullQuality);
        neighbours.forEach(each -> text.append(", neighbour ")
                .append(each.frequencyIndex)
                .append(" BSIC ")
                .append(each.identityCode)
                .append(": ")
                .append(each.level));
        return text.toString();
    }

    byte[] value() {
        Bits bits = new Bits(new byte[LENGTH]);
        bits.put(usesSecondList ? 1 : 0, 1);
        bits.put(usesDtx ? 1 : 0, 1);
        bits.put(fullLevel, 6);
        bits.put(0, 1);
        bits.put(isValid ? 0 : 1, 1);
        bits.put(subLevel, 6);
        bits.put(0, 1);
        bits.put(fullQuality, 3);
        bits.put(subQuality, 3);
        bits.put(neighbours.size(), 3);
        for (Neighbour neighbour : neighbours) {
            bits.put(neighbour.level, 6);
            bits.put(neighbour.frequencyIndex, 5);
            bits.put(neighbour.identityCode, 6);
        }
        return bits.octets;
    }

    static MeasurementResults read(MessageReader in) throws ProtocolViolation {
        Bits bits = new Bits(in.bytes(LENGTH, "measurement results"));
        boolean usesSecondList = bits.take(1) == 1;
        boolean usesDtx = bits.take(1) == 1;
        int fullLevel = bits.take(6);
        bits.take(1);
        boolean isValid = bits.take(1) == 0;
        int subLevel = bits.take(6);
        bits.take(1);
        int fullQuality = bits.take(3);
        int subQuality = bits.take(3);
        int count = bits.take(3);
        List<Neighbour> neighbours = new ArrayList<>();
        for (int i = 0; i < count && count != NOT_AVAILABLE; i++) {
            neighbours.add(new Neighbour(bits.take(6), bits.take(5), bits.take(6)));
        }
        return new MeasurementResults(
                usesSecondList, usesDtx, isValid, fullLevel, subLevel, fullQuality, subQuality, neighbours);
    }

    /** Octets as a row of bits, the highest of each octet first. */
    private static final class Bits {
        final byte[] octets;
        private int position;

        Bits(byte[] octets) {
            this.octets = octets;
        }

        void put(int value, int count) {
            for (int bit = count - 1; bit >= 0; bit--, position++) {
                octets[position / 8] |= (byte) ((value >> bit & 1) << (7 - position % 8));
            }
        }

        int take(int count) {
            int value = 0;
            for (int i = 0; i < count && position < BITS; i++, position++) {
                value = value << 1 | octets[position / 8] >> (7 - position % 8) & 1;
            }
            return value;
        }
    }
}
