package simgsm.cells.snapshot;

import java.util.List;
import simgsm.cells.town.Town;

/**
 * The whole program at one moment.
 *
 * @param nanos the owner thread's time
 * @param port for terminals
 * @param controller its address, as "127.0.0.1:3003"
 * @param isOsmocom true if the controller is osmo-bsc
 * @param isPaused true while walks are paused
 * @param cells in the order of the town's towers
 * @param mobiles in the order of their numbers
 * @param passing newest last, at most some hundreds
 */
public record TownSnapshot(
        long nanos,
        Town town,
        int port,
        String controller,
        boolean isOsmocom,
        ControllerLink link,
        boolean isPaused,
        List<CellState> cells,
        List<MobileState> mobiles,
        List<PassingStep> passing) {
    /** The state of the towers' connections to the controller. */
    public enum ControllerLink {
        /** All towers in operation are connected. */
        UP,
        /** Some of them are not connected. */
        PARTLY,
        SEARCHING
    }

    public TownSnapshot {
        cells = List.copyOf(cells);
        mobiles = List.copyOf(mobiles);
        passing = List.copyOf(passing);
    }
}
