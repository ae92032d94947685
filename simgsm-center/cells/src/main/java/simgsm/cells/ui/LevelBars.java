package simgsm.cells.ui;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.accessibility.AccessibleRole;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.snapshot.MobileState.Level;
import simgsm.cells.town.Tower;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/**
 * A bar for each received cell: the level of the last measurement, a tick at the average used by the decision, and a
 * line at the level that a neighbour's average has to reach.
 */
final class LevelBars extends PaintedComponent {
    static final int ROWS = 7;
    private static final int ROW_UNITS = 24;
    private static final double WEAKEST_DBM = -110;
    private static final double STRONGEST_DBM = -45;
    private static final int NAME_UNITS = 72;
    private static final int FIGURE_UNITS = 60;
    private static final int C2_UNITS = 98;

    private final TextBundle texts;
    private transient List<Tower> towers = List.of();
    private transient Optional<MobileState> mobile = Optional.empty();

    LevelBars(TextBundle texts) {
        super(AccessibleRole.LABEL);
        this.texts = texts;
        setName("levels");
        setToolTipText(texts.of("levels.why"));
    }

    void show(List<Tower> all, Optional<MobileState> shown) {
        if (all.size() != towers.size()) {
            revalidate();
        }
        change(() -> {
            towers = all;
            mobile = shown;
        });
        repaint();
    }

    @Override
    protected String spoken() {
        return mobile.map(state -> state.levels().stream()
                        .limit(ROWS)
                        .map(level -> level.cell() + " " + figures(level))
                        .collect(Collectors.joining(", ")))
                .filter(text -> !text.isEmpty())
                .orElse(texts.of("levels.none"));
    }

    /** The average if the decision has one, else the last level; in idle mode also C2. */
    private String figures(Level level) {
        long dbm = Math.round(level.averageDbm().orElse(level.dbm()));
        return level.c2().isPresent()
                ? texts.of(
                        "levels.c2",
                        String.valueOf(dbm),
                        String.valueOf(Math.round(level.c2().getAsDouble())))
                : texts.of("levels.dbm", String.valueOf(dbm));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(280), height());
    }

    private int height() {
        return Theme.px(Math.min(ROWS, towers.size()) * ROW_UNITS);
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(220), height());
    }

    /** The bar's end for a level, 0 to 1. */
    static double share(double dbm) {
        return Math.max(0, Math.min(1, (dbm - WEAKEST_DBM) / (STRONGEST_DBM - WEAKEST_DBM)));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        if (mobile.isEmpty() || mobile.get().levels().isEmpty()) {
            g.setFont(Theme.base());
            g.setColor(Theme.color(Ink.QUIET));
            g.drawString(texts.of("levels.none"), 0, g.getFontMetrics().getAscent());
            return;
        }
        List<Level> levels = mobile.get().levels();
        double row = Theme.exact(ROW_UNITS);
        double from = Theme.exact(NAME_UNITS);
        boolean isIdle = levels.get(0).c2().isPresent();
        double track = Math.max(1, width - from - Theme.exact(isIdle ? C2_UNITS : FIGURE_UNITS));
        int rows = Math.min(ROWS, levels.size());
        for (int i = 0; i < rows; i++) {
            bar(g, levels.get(i), i == 0, i * row, from, track, width);
        }
        if (!isIdle && rows > 1) {
            double line =
                    from + track * share(levels.get(0).dbm() + mobile.get().marginDecibels());
            g.setColor(Theme.color(Ink.DANGER));
            g.setStroke(Theme.dashed(1.6, 4));
            Drawing.line(g, line, row, line, rows * row);
        }
    }

    private void bar(
            Graphics2D g, Level level, boolean isServing, double top, double from, double track, double width) {
        double middle = top + Theme.exact(ROW_UNITS) / 2;
        Font font = isServing ? Theme.strong() : Theme.base();
        double base = middle + Drawing.capHeight(g, font) / 2;
        g.setFont(font);
        g.setColor(Theme.color(Ink.TEXT));
        g.drawString(Drawing.fitted(font, level.cell(), from - Theme.exact(6)), 0, (float) base);
        double thick = Theme.exact(isServing ? 12 : 9);
        g.setColor(Theme.color(Ink.LINE));
        Drawing.fillCrisp(g, from, middle - thick / 2, track, thick);
        g.setColor(Theme.color(CellInk.of(indexOf(level.cell()))));
        Drawing.fillCrisp(g, from, middle - thick / 2, track * share(level.dbm()), thick);
        if (level.averageDbm().isPresent()) {
            double tick = from + track * share(level.averageDbm().getAsDouble());
            g.setColor(Theme.color(Ink.TEXT));
            Drawing.fillCrisp(g, tick - Theme.exact(1), middle - Theme.exact(9), Theme.exact(2), Theme.exact(18));
        }
        g.setFont(Theme.monoSmall());
        g.setColor(Theme.color(Ink.TEXT));
        Drawing.rightAligned(g, figures(level), width, middle + Drawing.capHeight(g, Theme.monoSmall()) / 2);
    }

    private int indexOf(String cell) {
        for (int i = 0; i < towers.size(); i++) {
            if (towers.get(i).name().equals(cell)) {
                return i;
            }
        }
        return -1;
    }
}
