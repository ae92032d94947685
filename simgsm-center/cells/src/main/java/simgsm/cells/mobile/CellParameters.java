package simgsm.cells.mobile;

import simgsm.cells.tower.BaseStation;
import simgsm.cells.town.CellSelection;
import simgsm.rr.SystemInformation;

/**
 * A cell's broadcast parameters for mobiles in idle mode (TS 45.008, 6.4 and 9).
 *
 * @param area location area code
 * @param accessMinimumDbm RXLEV_ACCESS_MIN
 * @param missingPowerDecibels MS_TXPWR_MAX_CCH minus the handset's output
 * @param hysteresisDecibels CELL_RESELECT_HYSTERESIS
 * @param offsetDecibels CELL_RESELECT_OFFSET
 * @param temporaryOffsetDecibels TEMPORARY_OFFSET; may be infinite
 * @param penaltySeconds PENALTY_TIME; -1 if the offset is subtracted permanently
 */
public record CellParameters(
        int area,
        int accessMinimumDbm,
        int missingPowerDecibels,
        int hysteresisDecibels,
        int offsetDecibels,
        double temporaryOffsetDecibels,
        int penaltySeconds) {
    /** RXLEV 0 (TS 45.008, 8.1.4). */
    private static final int RXLEV_0_DBM = -110;

    /** The parameters that the controller has sent to the tower; missing ones are the town's. */
    public static CellParameters of(BaseStation tower) {
        CellSelection town = tower.tower().selection();
        if (tower.cell().isEmpty()) {
            return of(tower.area(), town);
        }
        SystemInformation.Type3 cell = tower.cell().get();
        var selection = cell.selection();
        var reselection = cell.reselection()
                .orElse(new SystemInformation.Reselection(
                        town.offsetDecibels(), town.temporaryOffsetDecibels(), town.penaltySeconds()));
        return new CellParameters(
                tower.area(),
                RXLEV_0_DBM + selection.accessMin(),
                MobilePower.missingDecibels(tower.tower().arfcn(), selection.powerLevel()),
                selection.hysteresisDecibels(),
                reselection.offsetDecibels(),
                reselection.temporaryOffsetDecibels(),
                reselection.penaltySeconds());
    }

    /** The parameters of a town file. */
    public static CellParameters of(int area, CellSelection town) {
        return new CellParameters(
                area,
                RXLEV_0_DBM + town.accessMinimumRxlev(),
                0,
                town.hysteresisDecibels(),
                town.offsetDecibels(),
                town.temporaryOffsetDecibels(),
                town.penaltySeconds());
    }

    /** C1 (TS 45.008, 6.4). @param levelDbm average received level */
    public double c1(double levelDbm) {
        return levelDbm - accessMinimumDbm - missingPowerDecibels;
    }

    /**
     * C2 (TS 45.008, 6.4).
     *
     * @param knownSeconds time among the six strongest cells; infinite for the serving cell
     */
    public double c2(double levelDbm, double knownSeconds) {
        double c1 = c1(levelDbm);
        if (penaltySeconds < 0) {
            return c1 - offsetDecibels;
        }
        double temporary = knownSeconds < penaltySeconds ? temporaryOffsetDecibels : 0;
        return c1 + offsetDecibels - temporary;
    }
}
