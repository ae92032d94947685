package simgsm.center.bsc;

import java.util.function.Supplier;
import simgsm.center.bsc.handover.HandoverDecision;
import simgsm.center.bsc.handover.PowerBudgetDecision;
import simgsm.center.bsc.handover.PowerBudgetSettings;
import simgsm.octets.Bounds;

/**
 * What all cells of the controller have in common.
 *
 * @param radioLinkTimeout SACCH blocks, 4 to 64 in steps of 4
 * @param t3212SixMinutes period of location updating in units of 6 minutes, 0 for none
 * @param decision makes the handover decision of a new traffic channel
 */
public record CellSettings(int radioLinkTimeout, int t3212SixMinutes, Supplier<HandoverDecision> decision) {
    public static final CellSettings STANDARD =
            new CellSettings(32, 5, () -> new PowerBudgetDecision(PowerBudgetSettings.STANDARD));

    public CellSettings {
        Bounds.check("radio link time-out", radioLinkTimeout, 4, 64);
        Bounds.checkOctet("T3212", t3212SixMinutes);
    }
}
