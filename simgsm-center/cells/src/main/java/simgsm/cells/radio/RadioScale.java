package simgsm.cells.radio;

/** The scales of reports by mobiles and towers (TS 45.008, 8.1.4 and 8.2.4; TS 45.010, 5.6). */
public final class RadioScale {
    public static final int RXLEV_MAX = 63;
    public static final int RXQUAL_MAX = 7;
    public static final int TIMING_ADVANCE_MAX = 63;
    /** One step of the timing advance: a bit of 48/13 us there and back, at the speed of light. */
    public static final double TIMING_STEP_METRES = 299.792458 * 48 / 13 / 2;

    private static final int RXLEV_ZERO_DBM = -110;
    /** Lower limits of the bit error rate for RXQUAL 1 to 7. */
    private static final double[] QUALITY_LIMITS = {0.002, 0.004, 0.008, 0.016, 0.032, 0.064, 0.128};

    private RadioScale() {}

    /** RXLEV 0 (below -110 dBm) to 63 (-48 dBm and above). */
    public static int rxlev(double dbm) {
        return (int) Math.max(0, Math.min(RXLEV_MAX, Math.ceil(dbm - RXLEV_ZERO_DBM)));
    }

    /** RXQUAL 0 (below 0.2 %) to 7 (12.8 % and above). @param bitErrorRate before decoding, 0 to 0.5 */
    public static int rxqual(double bitErrorRate) {
        int quality = 0;
        while (quality < RXQUAL_MAX && bitErrorRate >= QUALITY_LIMITS[quality]) {
            quality++;
        }
        return quality;
    }

    /** Timing advance 0 to 63 for a distance, rounded to the nearest step; beyond 35 km it stays 63. */
    public static int timingAdvance(double metres) {
        return (int) Math.min(TIMING_ADVANCE_MAX, Math.round(metres / TIMING_STEP_METRES));
    }
}
