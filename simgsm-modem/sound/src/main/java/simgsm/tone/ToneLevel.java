package simgsm.tone;

/**
 * Levels in dBm0 against 16-bit samples: A-law's loudest sine, a full-scale one, is at 3.14 dBm0 (ITU-T G.711, table
 * 5), so 0 dBm0 peaks at 22 827 and -10 dBm0 at 7218.
 */
public final class ToneLevel {
    public static final double FULL_SCALE_DBM0 = 3.14;
    private static final double FULL_SCALE = 32768;

    private ToneLevel() {}

    /** Peak of a sine of that level, in sample units. */
    public static double amplitude(double dbm0) {
        return FULL_SCALE * Math.pow(10, (dbm0 - FULL_SCALE_DBM0) / 20);
    }

    /** Level of a sine of that peak in sample units. */
    public static double dbm0(double amplitude) {
        return FULL_SCALE_DBM0 + 20 * Math.log10(amplitude / FULL_SCALE);
    }
}
