package simgsm.cells.town;

import simgsm.octets.Bounds;

/**
 * A base station with one cell.
 *
 * @param name used in commands and events
 * @param heightMetres of the antenna above the ground
 * @param powerDbm radiated power at the start, antenna gain included
 * @param arfcn channel number of the BCCH carrier, see {@link Frequencies}
 * @param bsic base station identity code, 0 to 63: network colour code times 8, plus base station colour code
 * @param area location area code, 0 to 65535; the controller's system information overrides it
 * @param cellIdentity 0 to 65535, unique in the location area; likewise
 * @param site first part of the unit id that the tower sends to the controller, as 6969 in 6969/0/0
 * @param trafficChannels time slots for speech, 1 to 7
 */
public record Tower(
        String name,
        TownPlace place,
        double heightMetres,
        double powerDbm,
        int arfcn,
        int bsic,
        int area,
        int cellIdentity,
        int site,
        int trafficChannels,
        CellSelection selection) {
    private static final int MOST_ARFCN = 1023;
    private static final int MOST_BSIC = 63;
    private static final int MOST_16_BITS = 0xffff;
    private static final int STANDARD_TRAFFIC_CHANNELS = 6;
    private static final int MOST_TRAFFIC_CHANNELS = 7;

    public Tower {
        Bounds.check("ARFCN", arfcn, 0, MOST_ARFCN);
        Bounds.check("BSIC", bsic, 0, MOST_BSIC);
        Bounds.check("location area code", area, 0, MOST_16_BITS);
        Bounds.check("cell identity", cellIdentity, 0, MOST_16_BITS);
        Bounds.check("site", site, 0, MOST_16_BITS);
        Bounds.check("traffic channels", trafficChannels, 1, MOST_TRAFFIC_CHANNELS);
    }

    /** Creates a tower with six traffic channels and the usual selection; its site is also its cell identity. */
    public Tower(
            String name,
            TownPlace place,
            double heightMetres,
            double powerDbm,
            int arfcn,
            int bsic,
            int area,
            int site) {
        this(
                name,
                place,
                heightMetres,
                powerDbm,
                arfcn,
                bsic,
                area,
                site,
                site,
                STANDARD_TRAFFIC_CHANNELS,
                CellSelection.STANDARD);
    }

    /** Site, BTS and transceiver, as in osmo-bsc and the centre. */
    public String unitId() {
        return site + "/0/0";
    }
}
