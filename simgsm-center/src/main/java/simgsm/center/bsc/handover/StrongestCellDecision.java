package simgsm.center.bsc.handover;

import java.util.Optional;
import simgsm.octets.Bounds;

/**
 * Moves a mobile when the same neighbour was the strongest, and stronger than the serving cell by a margin, in a number
 * of successive results: easy to follow on a map, and faster than a window of averages.
 */
public final class StrongestCellDecision implements HandoverDecision {
    /**
     * The numbers of the decision.
     *
     * @param marginDecibels 0 to 63
     * @param results in a row, 480 ms each, 1 to 100
     */
    public record Settings(int marginDecibels, int results) {
        public static final Settings STANDARD = new Settings(6, 4);

        public Settings {
            Bounds.check("margin", marginDecibels, 0, 63);
            Bounds.check("number of results", results, 1, 100);
        }
    }

    private final Settings settings;
    private Optional<NeighbourCell> candidate = Optional.empty();
    private int inARow;

    public StrongestCellDecision(Settings settings) {
        this.settings = settings;
    }

    @Override
    public void add(Measurement measurement) {
        Optional<NeighbourCell> strongest = measurement.neighbours().stream()
                .filter(each -> measurement.isValid()
                        && each.level() >= measurement.level() + settings.marginDecibels()
                        && each.level() > measurement.level())
                .max((one, other) -> Integer.compare(one.level(), other.level()))
                .map(Measurement.Neighbour::cell);
        inARow = strongest.equals(candidate) ? inARow + 1 : 1;
        candidate = strongest;
    }

    @Override
    public Optional<Target> target() {
        return candidate
                .filter(cell -> inARow >= settings.results())
                .map(cell -> new Target(cell, Reason.POWER_BUDGET));
    }
}
