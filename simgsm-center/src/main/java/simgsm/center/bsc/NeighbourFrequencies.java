package simgsm.center.bsc;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import simgsm.rr.Band;
import simgsm.rr.FrequencyList;

/**
 * The neighbours of a cell in up to three lists, as osmo-bsc divides them (TS 44.018, 3.4.1.2.1.1): those of the cell's band
 * in one list or, for want of room, two; those of the other band in a third.
 *
 * @param first for SYSTEM INFORMATION TYPE 2 and 5
 * @param more for TYPE 2bis and 5bis
 * @param other for TYPE 2ter and 5ter
 */
record NeighbourFrequencies(List<Integer> first, List<Integer> more, List<Integer> other) {
    static final NeighbourFrequencies NONE = new NeighbourFrequencies(List.of(), List.of(), List.of());

    /**
     * The lists of a cell.
     *
     * @throws IllegalArgumentException if they have no room for all
     */
    static NeighbourFrequencies of(int own, Collection<Integer> neighbours) {
        List<Integer> same = new ArrayList<>();
        List<Integer> other = new ArrayList<>();
        for (int arfcn :
                neighbours.stream().distinct().sorted(FrequencyList.ORDER).toList()) {
            (Band.of(arfcn) == Band.of(own) ? same : other).add(arfcn);
        }
        FrequencyList.encode(other);
        if (FrequencyList.find(same).isPresent()) {
            return new NeighbourFrequencies(same, List.of(), other);
        }
        int half = same.size() / 2;
        List<Integer> more = same.subList(half, same.size());
        FrequencyList.encode(same.subList(0, half));
        FrequencyList.encode(more);
        return new NeighbourFrequencies(same.subList(0, half), more, other);
    }

    /** All frequencies in the order of measurement reports (TS 44.018, 10.5.2.20). */
    List<Integer> inReports() {
        List<Integer> all = new ArrayList<>(first);
        all.addAll(more);
        all.addAll(other);
        return all;
    }
}
