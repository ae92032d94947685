package simgsm.center.bsc.handover;

import simgsm.octets.Bounds;

/**
 * The numbers of {@link PowerBudgetDecision}, with the names and values of osmo-bsc's algorithm 1.
 *
 * @param levelWindow results in the average of the serving cell's level, 1 to 10
 * @param neighbourWindow results in the average of a neighbour's level, 1 to 10
 * @param interval results between two comparisons with the neighbours, 1 to 99
 * @param hysteresisDecibels margin of a better neighbour, 0 to 999
 * @param maximumDistance timing advance above which the mobile moves, 0 to 9999
 * @param badQuality RXQUAL from which a result counts as bad
 * @param badResults number of bad ones among the last {@code qualityWindow} that moves the mobile
 * @param interferenceDbm level above which bad quality is interference
 * @param lowLevelDbm level at and below which the mobile moves
 */
public record PowerBudgetSettings(
        int levelWindow,
        int neighbourWindow,
        int interval,
        int hysteresisDecibels,
        int maximumDistance,
        int badQuality,
        int badResults,
        int qualityWindow,
        int interferenceDbm,
        int lowLevelDbm) {
    public static final PowerBudgetSettings STANDARD = new PowerBudgetSettings(10, 10, 6, 3, 9999, 5, 3, 4, -85, -110);

    public PowerBudgetSettings {
        Bounds.check("level window", levelWindow, 1, PowerBudgetDecision.MOST_RESULTS);
        Bounds.check("neighbour window", neighbourWindow, 1, PowerBudgetDecision.MOST_RESULTS);
        Bounds.check("power budget interval", interval, 1, 99);
        Bounds.check("hysteresis", hysteresisDecibels, 0, 999);
        Bounds.check("maximum distance", maximumDistance, 0, 9999);
        Bounds.check("quality window", qualityWindow, 1, PowerBudgetDecision.MOST_RESULTS);
    }
}
