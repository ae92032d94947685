package simgsm.cells.town;

import simgsm.octets.Bounds;

/**
 * A base station with one cell.
 *
 * @param name stands in commands and events
 * @param powerDbm radiated power
 * @param arfcn channel number of the BCCH carrier, 0 to 1023
 * @param bsic base station identity code, 0 to 63: network colour code times 8, plus base station colour code
 * @param area location area code, 0 to 65535; the controller's system information has the last word
 * @param site first part of the unit id that the tower tells the controller, as 6969 in 6969/0/0
 */
public record Tower(
        String name, Place place, double heightMetres, double powerDbm, int arfcn, int bsic, int area, int site) {
    private static final int MOST_ARFCN = 1023;
    private static final int MOST_BSIC = 63;
    private static final int MOST_16_BITS = 0xffff;

    public Tower {
        Bounds.check("ARFCN", arfcn, 0, MOST_ARFCN);
        Bounds.check("BSIC", bsic, 0, MOST_BSIC);
        Bounds.check("location area code", area, 0, MOST_16_BITS);
        Bounds.check("site", site, 0, MOST_16_BITS);
    }

    /** Site, BTS and transceiver, as osmo-bsc and the centre know the cell. */
    public String unitId() {
        return site + "/0/0";
    }
}
