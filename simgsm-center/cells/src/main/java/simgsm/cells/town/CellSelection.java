package simgsm.cells.town;

/**
 * Parameters of cell selection and reselection (TS 45.008, 6.4 and 9). A controller that sends SYSTEM INFORMATION overrides
 * them.
 *
 * @param accessMinimumRxlev RXLEV_ACCESS_MIN, 0 to 63
 * @param hysteresisDecibels CELL_RESELECT_HYSTERESIS, 0 to 14 in steps of 2
 * @param offsetDecibels CELL_RESELECT_OFFSET, 0 to 126 in steps of 2
 * @param temporaryOffsetDecibels TEMPORARY_OFFSET, 0 to 60 in steps of 10; 70 for infinite
 * @param penaltySeconds PENALTY_TIME, 20 to 620 in steps of 20
 */
public record CellSelection(
        int accessMinimumRxlev,
        int hysteresisDecibels,
        int offsetDecibels,
        int temporaryOffsetDecibels,
        int penaltySeconds) {
    /** Access from -105 dBm, 4 dB of hysteresis, no offsets. */
    public static final CellSelection STANDARD = new CellSelection(5, 4, 0, 0, 20);
}
