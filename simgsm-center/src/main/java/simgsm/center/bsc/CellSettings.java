package simgsm.center.bsc;

import java.util.concurrent.TimeUnit;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.octets.Bounds;

/**
 * Settings of all cells of the controller.
 *
 * @param t3212SixMinutes period of location updating in units of 6 minutes, 0 for none
 * @param handover decides when a call moves to another cell
 */
public record CellSettings(int t3212SixMinutes, HandoverAlgorithm handover) {
    /** Location updating every 30 minutes, as in osmo-bsc's usual configuration. */
    private static final int HALF_AN_HOUR = 5;

    private static final int PERIOD_MINUTES = 6;

    /** The usual settings with this algorithm. */
    public static CellSettings with(HandoverAlgorithm handover) {
        return new CellSettings(HALF_AN_HOUR, handover);
    }

    /** Two periods and a minute, as in osmo-msc; 0 for never. */
    public long implicitDetachNanos() {
        int minutes = 2 * PERIOD_MINUTES * t3212SixMinutes + 1;
        return t3212SixMinutes == 0 ? 0 : TimeUnit.MINUTES.toNanos(minutes);
    }

    public CellSettings {
        Bounds.checkOctet("T3212", t3212SixMinutes);
    }
}
