package simgsm.cells.mobile;

import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import simgsm.air.CipherAlgorithm;
import simgsm.air.RadioResource.CellDescription;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.town.TownPlace;

/** A mobile's reception and its place in the network. */
public interface MobileNetwork {
    List<BaseStation> towers();

    /** True if any tower is. */
    default boolean isInService() {
        return towers().stream().anyMatch(BaseStation::isInService);
    }

    /** The name of a tower by its index; empty for {@link IdleSelection#NONE}. */
    default String nameOf(int tower) {
        return tower == IdleSelection.NONE ? "" : towers().get(tower).tower().name();
    }

    /** The levels of all towers at a place in dBm. */
    void levelsDbm(TownPlace place, double[] into);

    /**
     * The carrier of one tower over noise and interference, in dB.
     *
     * @param levelsDbm of all towers at the place
     */
    double carrierDecibels(int tower, double[] levelsDbm);

    /** The tower of a HANDOVER COMMAND. */
    default OptionalInt find(CellDescription cell) {
        for (int i = 0; i < towers().size(); i++) {
            var tower = towers().get(i).tower();
            if (tower.arfcn() == cell.frequency() && tower.bsic() == cell.identityCode()) {
                return OptionalInt.of(i);
            }
        }
        return OptionalInt.empty();
    }

    /** A random number from 0 to less than 1, by the program's seed. */
    double random();

    /** The algorithms of the mobiles' radios and the towers. */
    Set<CipherAlgorithm> algorithms();

    /** True while walking mobiles are paused. */
    boolean isPaused();

    /** Reports that the mobile's number has become known. */
    void identified(Mobile mobile);

    void happened(MobileEvent event);
}
