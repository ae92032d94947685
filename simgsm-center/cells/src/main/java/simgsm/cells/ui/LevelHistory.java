package simgsm.cells.ui;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Stroke;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import javax.accessibility.AccessibleRole;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.snapshot.MobileState.Level;
import simgsm.cells.snapshot.PassingStep;
import simgsm.cells.snapshot.PassingStep.Kind;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.cells.town.Tower;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/**
 * The levels of a mobile's cells over the last 60 s, the newest at the right: a thin line for the measurements of each cell, a
 * thick one for the averages that decide, a dashed one for the level that a neighbour has to reach, and a mark with the new
 * cell at each handover and reselection.
 */
final class LevelHistory extends PaintedComponent {
    private static final long SPAN_NANOS = TimeUnit.SECONDS.toNanos(60);
    private static final long SAMPLE_NANOS = TimeUnit.SECONDS.toNanos(1);
    private static final Set<Kind> DECISIONS = EnumSet.of(Kind.HANDOVER_COMMAND, Kind.RESELECTION);
    private static final String BEGIN = "-60 s";
    private static final int HEIGHT_UNITS = 110;
    private static final int SCALE_UNITS = 30;
    private static final List<Integer> SCALE_DBM = List.of(-50, -70, -90, -110);

    private record Sample(long nanos, List<Level> levels, double marginDecibels) {}

    private final TextBundle texts;
    private final Deque<Sample> samples = new ArrayDeque<>();
    private transient List<PassingStep> decisions = List.of();
    private transient List<String> towers = List.of();
    private Optional<String> number = Optional.empty();

    LevelHistory(TextBundle texts) {
        super(AccessibleRole.LABEL);
        this.texts = texts;
        setName("levels.history");
        setToolTipText(texts.of("levels.history.why"));
    }

    /** Another mobile begins an empty history. */
    void show(TownSnapshot newest, Optional<MobileState> mobile) {
        if (!mobile.map(MobileState::number).equals(number)) {
            samples.clear();
            number = mobile.map(MobileState::number);
        }
        boolean isNew = mobile.isPresent()
                && (samples.isEmpty()
                        || newest.nanos() - samples.getLast().nanos() >= SAMPLE_NANOS
                        || !samples.getLast().levels().equals(mobile.get().levels()));
        towers = newest.town().towers().stream().map(Tower::name).toList();
        if (isNew) {
            MobileState it = mobile.get();
            samples.add(new Sample(newest.nanos(), it.levels(), it.marginDecibels()));
            while (samples.getFirst().nanos() < newest.nanos() - SPAN_NANOS) {
                samples.removeFirst();
            }
            repaint();
        }
        change(() -> decisions = newest.passing().stream()
                .filter(step -> DECISIONS.contains(step.kind()) && number.equals(Optional.of(step.number())))
                .filter(step ->
                        !samples.isEmpty() && step.nanos() >= samples.getFirst().nanos())
                .toList());
    }

    @Override
    protected String spoken() {
        return texts.of("levels.history", decisions.size());
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(280), Theme.px(HEIGHT_UNITS));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double left = Theme.exact(SCALE_UNITS);
        double bottom = height - Theme.exact(14);
        g.setFont(Theme.monoSmall());
        for (int dbm : SCALE_DBM) {
            double y = bottom * (1 - LevelBars.share(dbm));
            g.setColor(Theme.color(Ink.LINE));
            Drawing.horizontal(g, left, width, y);
            g.setColor(Theme.color(Ink.QUIET));
            g.drawString(String.valueOf(dbm), 0, (float) Math.max(y, Drawing.capHeight(g, Theme.monoSmall())));
        }
        g.drawString(BEGIN, (float) left, (float) height);
        if (samples.isEmpty()) {
            return;
        }
        g.clip(new Rectangle2D.Double(left, 0, width - left, height));
        for (int i = 0; i < towers.size(); i++) {
            String tower = towers.get(i);
            g.setColor(Theme.color(CellInk.of(i)));
            draw(g, width, bottom, Theme.stroke(1), sample -> level(sample, tower, false));
            draw(g, width, bottom, Theme.stroke(2.4), sample -> level(sample, tower, true));
        }
        g.setColor(Theme.color(Ink.DANGER));
        draw(g, width, bottom, Theme.dashed(1.2, 4), LevelHistory::limit);
        marks(g, width, bottom, height);
    }

    /** The newest first; a cell's name that has no room beside a newer one is left out. */
    private void marks(Graphics2D g, double width, double bottom, double height) {
        double gap = Theme.exact(4);
        double least = Theme.exact(SCALE_UNITS) + Drawing.width(Theme.monoSmall(), BEGIN) + gap;
        double free = width;
        g.setStroke(Theme.line());
        for (int i = decisions.size() - 1; i >= 0; i--) {
            PassingStep step = decisions.get(i);
            double x = x(step.nanos(), width);
            g.setColor(Theme.color(Ink.TEXT));
            Drawing.line(g, x, 0, x, bottom);
            String cell = step.kind() == Kind.RESELECTION ? step.from() : step.to();
            String words = "\u2192 " + cell;
            double begin = x - Drawing.width(Theme.monoSmall(), words);
            if (x <= free && begin >= least) {
                g.setColor(Theme.color(CellInk.of(towers.indexOf(cell))));
                Drawing.rightAligned(g, words, x, height);
                free = begin - gap;
            }
        }
    }

    private double x(long nanos, double width) {
        double age = (samples.getLast().nanos() - nanos) / (double) SPAN_NANOS;
        return width - age * (width - Theme.exact(SCALE_UNITS));
    }

    private static OptionalDouble level(Sample sample, String cell, boolean isAverage) {
        return sample.levels().stream()
                .filter(level -> level.cell().equals(cell))
                .findFirst()
                .map(level -> isAverage ? level.averageDbm() : OptionalDouble.of(level.dbm()))
                .orElse(OptionalDouble.empty());
    }

    /** The level that a neighbour's average has to reach in a connection; in idle mode C2 decides. */
    private static OptionalDouble limit(Sample sample) {
        return sample.levels().isEmpty() || sample.levels().get(0).c2().isPresent()
                ? OptionalDouble.empty()
                : OptionalDouble.of(sample.levels().get(0).dbm() + sample.marginDecibels());
    }

    private void draw(
            Graphics2D g, double width, double bottom, Stroke stroke, Function<Sample, OptionalDouble> value) {
        Path2D line = new Path2D.Double();
        boolean isPenDown = false;
        for (Sample sample : samples) {
            OptionalDouble dbm = value.apply(sample);
            if (dbm.isPresent()) {
                double x = x(sample.nanos(), width);
                double y = bottom * (1 - LevelBars.share(dbm.getAsDouble()));
                if (isPenDown) {
                    line.lineTo(x, y);
                } else {
                    line.moveTo(x, y);
                }
            }
            isPenDown = dbm.isPresent();
        }
        g.setStroke(stroke);
        g.draw(line);
    }
}
