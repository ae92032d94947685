package simgsm.cells.town;

import simgsm.rr.Band;

/** Frequencies of the GSM 900 and DCS 1800 channels (TS 45.005, clause 2). */
public final class Frequencies {
    private static final double SPACING_MEGAHERTZ = 0.2;

    private Frequencies() {}

    /** True for a channel number of GSM 900 (0 to 124, 975 to 1023) or DCS 1800 (512 to 885). */
    public static boolean isChannel(int arfcn) {
        return arfcn >= 0 && arfcn <= 124 || Band.of(arfcn) == Band.DCS_1800 || arfcn >= 975 && arfcn <= 1023;
    }

    /** The tower's transmit frequency. IllegalArgumentException for a number without a channel. */
    public static double downlinkMegahertz(int arfcn) {
        if (!isChannel(arfcn)) {
            throw new IllegalArgumentException("ARFCN " + arfcn + ", expected 0 to 124, 512 to 885 or 975 to 1023");
        }
        if (Band.of(arfcn) == Band.DCS_1800) {
            return 1805.2 + SPACING_MEGAHERTZ * (arfcn - 512);
        }
        return 935 + SPACING_MEGAHERTZ * (arfcn >= 975 ? arfcn - 1024 : arfcn);
    }
}
