package simgsm.cells.ui;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.util.OptionalInt;
import javax.accessibility.AccessibleRole;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/** The reports until the next decision: a dot for each, filled once received, and the number in words. */
final class DecisionCount extends PaintedComponent {
    private static final int MOST_DOTS = 10;

    private final TextBundle texts;
    private transient OptionalInt left = OptionalInt.empty();
    private int period = 1;
    private double margin;

    DecisionCount(TextBundle texts) {
        super(AccessibleRole.LABEL);
        this.texts = texts;
        setName("decision");
        setToolTipText(texts.of("decision.why"));
    }

    /**
     * @param reports until the next decision;
     * @param between two decisions;
     * @param decibels margin of the better cell
     */
    void show(OptionalInt reports, int between, double decibels) {
        change(() -> {
            left = reports;
            period = between;
            margin = decibels;
        });
    }

    @Override
    protected String spoken() {
        return left.isPresent() ? texts.of("decision", left.getAsInt(), Math.round(margin)) : texts.of("decision.none");
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(280), Theme.px(22));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double x = 0;
        double radius = Theme.exact(4);
        if (left.isPresent() && period > 1 && period <= MOST_DOTS) {
            for (int i = 0; i < period; i++) {
                var dot = new Ellipse2D.Double(x + 1, height / 2 - radius, 2 * radius, 2 * radius);
                g.setColor(Theme.color(Ink.ACCENT));
                g.setStroke(Theme.line());
                if (i < period - left.getAsInt()) {
                    g.fill(dot);
                }
                g.draw(dot);
                x += Theme.exact(12);
            }
            x += Theme.exact(4);
        }
        g.setFont(Theme.base());
        g.setColor(Theme.color(left.isPresent() ? Ink.TEXT : Ink.QUIET));
        g.drawString(Drawing.fitted(Theme.base(), spoken(), width - x), (float) x, (float)
                (height / 2 + Drawing.capHeight(g, Theme.base()) / 2));
    }
}
