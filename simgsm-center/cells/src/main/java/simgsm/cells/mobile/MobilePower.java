package simgsm.cells.mobile;

import simgsm.cells.town.Frequencies;

/** Output of a handset, power class 4 in GSM 900 and class 1 in DCS 1800, by power control level (TS 45.005, 4.1.1). */
final class MobilePower {
    /** Power control level of the full output of 33 dBm in GSM 900. */
    private static final int FULL_900 = 5;
    /** Power control level of the full output of 30 dBm in DCS 1800. */
    private static final int FULL_1800 = 0;
    /** Levels 29, 30, 31 of DCS 1800: 36, 34, 32 dBm. */
    private static final int FIRST_ABOVE_1800 = 29;

    private static final int LEVEL_DECIBELS = 2;

    private MobilePower() {}

    /** The level used for an ordered one, limited to the handset's full output. */
    static int used(int arfcn, int ordered) {
        if (Frequencies.isDcs1800(arfcn)) {
            return ordered >= FIRST_ABOVE_1800 ? FULL_1800 : ordered;
        }
        return Math.max(FULL_900, ordered);
    }

    /** Decibels by which a level exceeds the handset's full output. Levels 0 and 1 of GSM 900 equal level 2, 39 dBm. */
    static int missingDecibels(int arfcn, int level) {
        if (Frequencies.isDcs1800(arfcn)) {
            return level >= FIRST_ABOVE_1800 ? LEVEL_DECIBELS * (32 - level) : 0;
        }
        return LEVEL_DECIBELS * Math.max(0, FULL_900 - Math.max(2, level));
    }
}
