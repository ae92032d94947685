package simgsm.rr;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** System information that lists neighbour cells (TS 44.018, 9.1.32 to 9.1.34 and 9.1.37 to 9.1.39). */
public enum NeighbourList {
    /** For idle mobiles: frequencies of the cell's band. */
    TYPE_2(0x02, 0x1a, 22),
    /** More of the cell's band. */
    TYPE_2_BIS(0x0a, 0x02, 21),
    /** Frequencies of the other bands. */
    TYPE_2_TER(0x0b, 0x03, 18),
    /** For mobiles on a dedicated channel, like {@link #TYPE_2} and those after it. */
    TYPE_5(0x05, 0x1d, 18),
    TYPE_5_BIS(0x0d, 0x05, 18),
    TYPE_5_TER(0x0e, 0x06, 18);

    private final int informationType;
    private final int messageType;
    private final int pseudoLength;

    NeighbourList(int informationType, int messageType, int pseudoLength) {
        this.informationType = informationType;
        this.messageType = messageType;
        this.pseudoLength = pseudoLength;
    }

    /** The system information type of an RSL message (TS 48.058, 9.3.30). */
    public int informationType() {
        return informationType;
    }

    public int messageType() {
        return messageType;
    }

    /** L2 pseudo length. */
    public int pseudoLength() {
        return pseudoLength;
    }

    /** True for mobiles on a dedicated channel. */
    public boolean isDedicated() {
        return compareTo(TYPE_5) >= 0;
    }

    /** True for frequencies of other bands than the cell's. */
    public boolean isOfOtherBands() {
        return this == TYPE_2_TER || this == TYPE_5_TER;
    }

    /** The frequencies in the order of measurement reports (10.5.2.20): those of 5 and 5bis together, then those of 5ter. */
    public static List<Integer> inReports(Map<NeighbourList, List<Integer>> lists) {
        return Stream.concat(
                        Stream.of(TYPE_5, TYPE_5_BIS)
                                .flatMap(list -> lists.getOrDefault(list, List.of()).stream())
                                .distinct()
                                .sorted(FrequencyList.ORDER),
                        lists.getOrDefault(TYPE_5_TER, List.of()).stream())
                .toList();
    }
}
