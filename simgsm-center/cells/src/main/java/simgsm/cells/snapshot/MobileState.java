package simgsm.cells.snapshot;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import simgsm.cells.town.TownPlace;

/**
 * A phone or robot in the town.
 *
 * @param number its number, or while that is unknown a word for its connection
 * @param cell the tower of its cell or connection; empty for none
 * @param isInCall true if it has a traffic channel
 * @param isCiphered true while its connection is ciphered
 * @param path the points ahead on its walk; empty at rest
 * @param levels the serving cell first, then up to six neighbours, strongest first
 * @param quality RXQUAL of the serving cell, 0 to 7; empty in idle mode
 * @param timingAdvance steps of 553.5 m; empty in idle mode
 * @param linkCounter radio link counter, SACCH blocks left; empty in idle mode
 * @param reportsToDecision reports until the next comparison of neighbours; empty in idle mode
 * @param periodReports reports between two such comparisons
 * @param marginDecibels advantage of a neighbour's average over the serving level; C2 hysteresis in idle mode
 * @param gapMillis silence during its last handover; empty before
 */
public record MobileState(
        String number,
        TownPlace place,
        String cell,
        State state,
        boolean isInCall,
        boolean isCiphered,
        List<TownPlace> path,
        List<Level> levels,
        OptionalInt quality,
        OptionalInt timingAdvance,
        OptionalInt linkCounter,
        OptionalInt reportsToDecision,
        int periodReports,
        double marginDecibels,
        OptionalInt gapMillis) {
    /** A mobile's activity. */
    public enum State {
        /** No cell is suitable. */
        SEARCHING,
        IDLE,
        DEDICATED,
        /** Between two cells. */
        HANDOVER
    }

    /**
     * A mobile's reception of one cell.
     *
     * @param dbm of the last measurement
     * @param averageDbm over the reports of the decision; empty if there are too few
     * @param c2 the criterion of idle mode in dB; empty in a connection
     */
    public record Level(String cell, double dbm, OptionalDouble averageDbm, OptionalDouble c2) {}

    public MobileState {
        path = List.copyOf(path);
        levels = List.copyOf(levels);
    }
}
