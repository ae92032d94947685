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

/** The reports until the next decision: a dot for each, filled for those that have come, and the number in words. */
final class DecisionCount extends PaintedComponent {
    /** osmo-bsc compares the neighbours at every sixth report. */
    private static final int PERIOD = 6;

    private final TextBundle texts;
    private transient OptionalInt left = OptionalInt.empty();

    DecisionCount(TextBundle texts) {
        super(AccessibleRole.LABEL);
        this.texts = texts;
        setName("decision");
        setToolTipText(texts.of("decision.why"));
    }

    void show(OptionalInt reports) {
        change(() -> left = reports);
    }

    @Override
    protected String spoken() {
        return left.isPresent() ? texts.of("decision", left.getAsInt()) : texts.of("decision.none");
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(280), Theme.px(22));
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double x = 0;
        double radius = Theme.exact(4);
        if (left.isPresent()) {
            int period = Math.max(PERIOD, left.getAsInt());
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
