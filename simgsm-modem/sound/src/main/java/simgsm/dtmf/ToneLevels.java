package simgsm.dtmf;

import java.util.Arrays;
import java.util.function.IntPredicate;
import simgsm.tone.ToneLevel;

/**
 * A receiver's last levels of the eight DTMF frequencies, and its limits for each group. Immutable; tones are
 * numbered 0 (697 Hz) to 3 (941 Hz) and 4 (1209 Hz) to 7 (1633 Hz).
 */
public final class ToneLevels {
    /** Lower levels are shown as this one. */
    public static final double FLOOR_DBM0 = -60;

    /** Silence before a receiver that requires nothing. */
    public static final ToneLevels SILENCE = new ToneLevels(new double[8], FLOOR_DBM0, FLOOR_DBM0, tone -> false);

    private final double[] dbm0;
    private final double leastRowDbm0;
    private final double leastColumnDbm0;
    private final boolean[] counts = new boolean[8];

    /**
     * @param amplitudes peaks in sample units, by tone
     * @param isProminent true for a tone that is prominent in its group
     */
    ToneLevels(double[] amplitudes, double leastRowDbm0, double leastColumnDbm0, IntPredicate isProminent) {
        dbm0 = Arrays.stream(amplitudes).map(ToneLevels::level).toArray();
        this.leastRowDbm0 = leastRowDbm0;
        this.leastColumnDbm0 = leastColumnDbm0;
        for (int tone = 0; tone < 8; tone++) {
            counts[tone] = dbm0[tone] > leastDbm0(tone) && isProminent.test(tone);
        }
    }

    private static double level(double amplitude) {
        return amplitude < 1 ? FLOOR_DBM0 : Math.max(FLOOR_DBM0, ToneLevel.dbm0(amplitude));
    }

    /** The level of a tone. */
    public double dbm0(int tone) {
        return dbm0[tone];
    }

    /** The level that the tone must exceed now: the receiver's lowest, or the limit of twist. */
    public double leastDbm0(int tone) {
        return tone < 4 ? leastRowDbm0 : leastColumnDbm0;
    }

    /** True if the tone exceeds {@link #leastDbm0} and is prominent in its group; a key needs two such tones. */
    public boolean counts(int tone) {
        return counts[tone];
    }
}
