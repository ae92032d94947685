package simgsm.center.ui.ladder;

import java.awt.Dimension;
import java.awt.Graphics2D;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/** The names of the lifelines, above the ladder. */
final class LifelineHeader extends PaintedComponent {

    private Lifelines lifelines = Lifelines.NONE;
    private double heightUnits = LadderDrawing.HEAD_UNITS;

    void show(Lifelines newLifelines) {
        lifelines = newLifelines;
        revalidate();
        repaint();
    }

    void setLow(boolean low) {
        heightUnits = low ? LadderDrawing.LOW_HEAD_UNITS : LadderDrawing.HEAD_UNITS;
    }

    LifelineHeader() {
        super(AccessibleRole.COLUMN_HEADER);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(lifelines.leastWidth(), Theme.px(heightUnits));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        g.setColor(Theme.color(Ink.CARD));
        g.fillRect(0, 0, getWidth(), getHeight());
        new LadderDrawing(new GraphicsCanvas(g), lifelines, getWidth() / Theme.zoom()).heads(heightUnits);
    }

    @Override
    protected String spoken() {
        return String.join(", ", lifelines.names());
    }
}
