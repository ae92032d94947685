package simgsm.cells.app;

import simgsm.cells.mobile.Mobile;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioState;
import simgsm.cells.network.CellNetwork;
import simgsm.cells.radio.RadioScale;
import simgsm.cells.town.TownPlace;
import simgsm.event.EventLine;

/** Answer to {@code mobiles}: idle or dedicated. @param state {@code idle} or {@code dedicated} */
@EventLine("mobile number=mobile.number x=place.xMetres:1 y=place.yMetres:1 cell=mobile.cell rxlev= state=")
public record MobileRow(Mobile mobile, TownPlace place, int rxlev, String state) {
    static MobileRow of(Mobile mobile, CellNetwork network) {
        TownPlace place = mobile.walker().place();
        int tower = mobile.serving();
        double[] levels = new double[network.towers().size()];
        network.levelsDbm(place, levels);
        return new MobileRow(
                mobile,
                place,
                tower < 0 ? 0 : RadioScale.rxlev(levels[tower]),
                mobile.state() == MobileRadioState.IDLE ? "idle" : "dedicated");
    }
}
