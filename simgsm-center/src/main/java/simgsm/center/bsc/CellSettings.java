package simgsm.center.bsc;

import java.util.function.Supplier;
import simgsm.center.bsc.handover.HandoverDecision;
import simgsm.center.bsc.handover.PowerBudgetDecision;
import simgsm.center.bsc.handover.PowerBudgetSettings;
import simgsm.octets.Bounds;

/**
 * What all cells of the controller have in common.
 *
 * @param t3212SixMinutes period of location updating in units of 6 minutes, 0 for none
 * @param decision makes the handover decision of a new traffic channel
 */
public record CellSettings(int t3212SixMinutes, Supplier<HandoverDecision> decision) {
    public static final CellSettings STANDARD =
            new CellSettings(5, () -> new PowerBudgetDecision(PowerBudgetSettings.STANDARD));

    public CellSettings {
        Bounds.checkOctet("T3212", t3212SixMinutes);
    }
}
