package simgsm.station;

/**
 * The serving cell of a station in a town, reported by a cells program.
 *
 * @param identity CI, 0 to 65535
 * @param areaCode LAC
 * @param rxlev 0 (below -110 dBm, nothing is received) to 63 (above -48 dBm)
 */
public record ServingCell(int identity, int areaCode, int rxlev) {
    private static final int RXLEV_ZERO_DBM = -110;
    /** RXLEV of a phone's first bar, and step of each further bar. */
    private static final int FIRST_BAR = 3;

    private static final int EACH_BAR = 8;

    /** The level in dBm. */
    public int dbm() {
        return rxlev + RXLEV_ZERO_DBM;
    }

    /** The bars on a phone: one from -107 dBm, and one more every 8 dB. */
    public int bars(int most) {
        return rxlev < FIRST_BAR ? 0 : Math.min(most, 1 + (rxlev - FIRST_BAR) / EACH_BAR);
    }
}
