package simgsm.rr;

/** The frequency bands of the network (TS 45.005, clause 2) and their power control levels of mobiles (4.1.1). */
public enum Band {
    /** GSM 900 with its extension: ARFCN 0 to 124 and 975 to 1023; handsets of class 4 send 33 dBm. */
    GSM_900(5, 33),
    /** DCS 1800: ARFCN 512 to 885; handsets of class 1 send 30 dBm. */
    DCS_1800(0, 30);

    private static final int FIRST_OF_DCS_1800 = 512;
    private static final int LAST_OF_DCS_1800 = 885;
    private static final int LEVEL_DECIBELS = 2;

    private final int fullLevel;
    private final int fullDbm;

    Band(int fullLevel, int fullDbm) {
        this.fullLevel = fullLevel;
        this.fullDbm = fullDbm;
    }

    /** The band of a channel number. */
    public static Band of(int arfcn) {
        return arfcn >= FIRST_OF_DCS_1800 && arfcn <= LAST_OF_DCS_1800 ? DCS_1800 : GSM_900;
    }

    /** Power control level of a handset's full output. */
    public int fullLevel() {
        return fullLevel;
    }

    /** A handset's full output. */
    public int fullDbm() {
        return fullDbm;
    }

    /** The level of an output, of the next stronger one if there is none. @param dbm at most the full output */
    public int level(int dbm) {
        return fullLevel + (fullDbm - dbm) / LEVEL_DECIBELS;
    }
}
