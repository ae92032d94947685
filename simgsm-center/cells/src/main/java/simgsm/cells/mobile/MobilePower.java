package simgsm.cells.mobile;

import simgsm.rr.Band;

/** Output of a handset, power class 4 in GSM 900 and class 1 in DCS 1800, by power control level (TS 45.005, 4.1.1). */
final class MobilePower {
    /** Levels 29, 30, 31 of DCS 1800: 36, 34, 32 dBm. */
    private static final int FIRST_ABOVE_1800 = 29;

    private static final int LEVEL_DECIBELS = 2;

    private MobilePower() {}

    /** The level used for an ordered one, limited to the handset's full output. */
    static int used(int arfcn, int ordered) {
        Band band = Band.of(arfcn);
        return band == Band.DCS_1800 && ordered >= FIRST_ABOVE_1800
                ? band.fullLevel()
                : Math.max(band.fullLevel(), ordered);
    }

    /** Decibels by which a level exceeds the handset's full output. Levels 0 and 1 of GSM 900 equal level 2, 39 dBm. */
    static int missingDecibels(int arfcn, int level) {
        if (Band.of(arfcn) == Band.DCS_1800) {
            return level >= FIRST_ABOVE_1800 ? LEVEL_DECIBELS * (32 - level) : 0;
        }
        return LEVEL_DECIBELS * Math.max(0, Band.GSM_900.fullLevel() - Math.max(2, level));
    }
}
