package simgsm.center.bsc.handover;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Algorithm 1 of osmo-bsc: at every sixth result the best neighbour whose average is 3 dB above the serving cell's level of this
 * result; at any result the best neighbour if quality, level or distance is bad. Checked against osmo-bsc 1.9 by the same
 * sequences of results.
 */
public final class PowerBudgetDecision implements HandoverDecision {
    /** Number of results and neighbours kept. */
    static final int MOST_RESULTS = 10;

    private final PowerBudgetSettings settings;
    private final List<Followed> neighbours = new ArrayList<>(MOST_RESULTS);
    private final List<Measurement> latest = new ArrayList<>(MOST_RESULTS);
    private Measurement last;
    private int count;

    private static final class Followed {
        final NeighbourCell cell;
        final LevelWindow levels = new LevelWindow();

        Followed(NeighbourCell cell) {
            this.cell = cell;
        }
    }

    public PowerBudgetDecision(PowerBudgetSettings settings) {
        this.settings = settings;
    }

    @Override
    public void add(Measurement measurement) {
        last = measurement;
        count++;
        if (latest.size() == MOST_RESULTS) {
            latest.remove(0);
        }
        latest.add(measurement);
        if (!measurement.neighbours().isEmpty()) {
            follow(measurement.neighbours());
        }
    }

    /** Level 0 counts for followed cells missing from a report; a report without neighbours counts for none. */
    private void follow(List<Measurement.Neighbour> reported) {
        List<Measurement.Neighbour> rest = new ArrayList<>(reported);
        for (Followed each : neighbours) {
            Optional<Measurement.Neighbour> found = rest.stream()
                    .filter(neighbour -> neighbour.cell().equals(each.cell))
                    .findFirst();
            found.ifPresent(rest::remove);
            each.levels.add(found.map(Measurement.Neighbour::level).orElse(0));
        }
        for (Measurement.Neighbour each : rest) {
            Followed followed = new Followed(each.cell());
            followed.levels.add(each.level());
            if (neighbours.size() < MOST_RESULTS) {
                neighbours.add(followed);
            } else {
                neighbours.set(worst(), followed);
            }
        }
    }

    private int worst() {
        int worst = 0;
        for (int i = 1; i < neighbours.size(); i++) {
            if (average(i) < average(worst)) {
                worst = i;
            }
        }
        return worst;
    }

    private int average(int index) {
        return neighbours.get(index).levels.average(MOST_RESULTS);
    }

    @Override
    public Optional<Target> target() {
        return reason().flatMap(reason -> best().map(cell -> new Target(cell, reason)));
    }

    private Optional<Reason> reason() {
        Optional<Integer> level = averageDbm();
        if (isQualityBad()) {
            // without an average the level counts as good
            boolean isLoud = level.map(dbm -> dbm > settings.interferenceDbm()).orElse(true);
            return Optional.of(isLoud ? Reason.INTERFERENCE : Reason.BAD_QUALITY);
        }
        if (level.isPresent() && level.get() <= settings.lowLevelDbm()) {
            return Optional.of(Reason.LOW_LEVEL);
        }
        if (last.timingAdvance() > settings.maximumDistance()) {
            return Optional.of(Reason.DISTANCE);
        }
        boolean isDue = last.number() % settings.interval() == settings.interval() - 1;
        return isDue ? Optional.of(Reason.POWER_BUDGET) : Optional.empty();
    }

    /** The serving cell's average over the window's valid results; empty before it is full. */
    private Optional<Integer> averageDbm() {
        if (count < settings.levelWindow()) {
            return Optional.empty();
        }
        int[] valid = window(settings.levelWindow()).stream()
                .filter(Measurement::isValid)
                .mapToInt(Measurement::averagedLevel)
                .toArray();
        if (valid.length == 0) {
            return Optional.empty();
        }
        int sum = 0;
        for (int level : valid) {
            sum += level;
        }
        return Optional.of(sum / valid.length - Measurement.RXLEV_OFFSET);
    }

    private boolean isQualityBad() {
        return window(settings.qualityWindow()).stream()
                        .filter(each -> each.isValid() && each.quality() >= settings.badQuality())
                        .count()
                >= settings.badResults();
    }

    private List<Measurement> window(int size) {
        return latest.subList(Math.max(0, latest.size() - size), latest.size());
    }

    private Optional<NeighbourCell> best() {
        Optional<NeighbourCell> best = Optional.empty();
        int bestMargin = 0;
        for (Followed each : neighbours) {
            int margin = each.levels.average(settings.neighbourWindow()) - last.level();
            if (margin >= settings.hysteresisDecibels() && margin > bestMargin) {
                best = Optional.of(each.cell);
                bestMargin = margin;
            }
        }
        return best;
    }
}
