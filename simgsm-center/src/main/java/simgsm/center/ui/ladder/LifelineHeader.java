package simgsm.center.ui.ladder;

import java.awt.Dimension;
import java.awt.Graphics2D;
import javax.accessibility.AccessibleRole;
import simgsm.center.msc.LadderEntry;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/** The names of the lifelines, above the ladder. */
final class LifelineHeader extends PaintedComponent {
    private static final double HEIGHT_UNITS = 36;
    private static final double BOX_UNITS = 24;

    private Lifelines lifelines = Lifelines.NONE;

    void show(Lifelines newLifelines) {
        lifelines = newLifelines;
        revalidate();
        repaint();
    }

    LifelineHeader() {
        super(AccessibleRole.CANVAS);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(lifelines.leastWidth(), Theme.px(HEIGHT_UNITS));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        g.setColor(Theme.color(Ink.CARD));
        g.fillRect(0, 0, getWidth(), getHeight());
        for (String name : lifelines.names()) {
            paintHead(g, name, lifelines.x(name, getWidth()));
        }
        g.setColor(Theme.color(Ink.LINE));
        Drawing.horizontal(g, 0, getWidth(), getHeight() - 1);
    }

    private void paintHead(Graphics2D g, String name, double x) {
        boolean isCenter = name.equals(LadderEntry.CENTER);
        double room = Math.min(lifelines.gap(getWidth()), Theme.exact(160)) - Theme.exact(8);
        String fitted = Drawing.fitted(Theme.monoStrong(), name, room - Theme.exact(12));
        double width = Math.min(room, Drawing.width(Theme.monoStrong(), fitted) + Theme.exact(20));
        double height = Theme.exact(BOX_UNITS);
        double top = (getHeight() - height) / 2;
        var box = Drawing.round(x - width / 2, top, width, height, Theme.exact(Theme.CONTROL_RADIUS));
        g.setColor(Theme.color(isCenter ? Ink.ACCENT : Ink.CARD));
        g.fill(box);
        g.setColor(Theme.color(isCenter ? Ink.ACCENT : Ink.CONTROL_LINE));
        g.setStroke(Theme.hairline());
        g.draw(box);
        g.setColor(Theme.color(isCenter ? Ink.ON_ACCENT : Ink.TEXT));
        Drawing.centred(g, fitted, Theme.monoStrong(), x, getHeight() / 2.0);
    }

    @Override
    protected String spoken() {
        return String.join(", ", lifelines.names());
    }
}
