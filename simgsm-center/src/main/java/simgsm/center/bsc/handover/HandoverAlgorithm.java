package simgsm.center.bsc.handover;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/** The available algorithms with their numbers, as text: {@code power-budget,interval=6,hysteresis=3}. */
public final class HandoverAlgorithm {
    /** osmo-bsc's algorithm 1 with its defaults. */
    public static final HandoverAlgorithm STANDARD = of("power-budget");

    private static final String EXPECTED =
            "power-budget[,levels=N][,neighbours=N][,interval=N][,hysteresis=DB][,distance=N]"
                    + " or strongest-cell[,margin=DB][,reports=N]";

    private final String name;
    private final Map<String, Integer> numbers;

    private HandoverAlgorithm(String name, Map<String, Integer> numbers) {
        this.name = name;
        this.numbers = numbers;
    }

    /** @throws IllegalArgumentException naming the expected text */
    public static HandoverAlgorithm of(String text) {
        String[] parts = text.split(",");
        Set<String> known = switch (parts[0]) {
            case "power-budget" -> Set.of("levels", "neighbours", "interval", "hysteresis", "distance");
            case "strongest-cell" -> Set.of("margin", "reports");
            default -> throw wrong(text);
        };
        Map<String, Integer> numbers = new LinkedHashMap<>();
        for (int i = 1; i < parts.length; i++) {
            String[] pair = parts[i].split("=", 2);
            if (pair.length < 2 || !known.contains(pair[0]) || !pair[1].matches("[0-9]{1,4}")) {
                throw wrong(text);
            }
            numbers.put(pair[0], Integer.parseInt(pair[1]));
        }
        HandoverAlgorithm algorithm = new HandoverAlgorithm(parts[0], numbers);
        algorithm.decision();
        return algorithm;
    }

    /** The margin in dB of a better cell. */
    public int marginDecibels() {
        return name.equals("power-budget")
                ? powerBudget().hysteresisDecibels()
                : strongestCell().marginDecibels();
    }

    private static IllegalArgumentException wrong(String text) {
        return new IllegalArgumentException("expected " + EXPECTED + ", found " + text);
    }

    /** Creates the decision for one mobile on a new traffic channel. */
    public HandoverDecision decision() {
        return name.equals("power-budget")
                ? new PowerBudgetDecision(powerBudget())
                : new StrongestCellDecision(strongestCell());
    }

    private PowerBudgetSettings powerBudget() {
        PowerBudgetSettings standard = PowerBudgetSettings.STANDARD;
        return new PowerBudgetSettings(
                number("levels", standard.levelWindow()),
                number("neighbours", standard.neighbourWindow()),
                number("interval", standard.interval()),
                number("hysteresis", standard.hysteresisDecibels()),
                number("distance", standard.maximumDistance()),
                standard.badQuality(),
                standard.badResults(),
                standard.qualityWindow(),
                standard.interferenceDbm(),
                standard.lowLevelDbm());
    }

    private StrongestCellDecision.Settings strongestCell() {
        StrongestCellDecision.Settings standard = StrongestCellDecision.Settings.STANDARD;
        return new StrongestCellDecision.Settings(
                number("margin", standard.marginDecibels()), number("reports", standard.results()));
    }

    private int number(String key, int standard) {
        return numbers.getOrDefault(key, standard);
    }
}
