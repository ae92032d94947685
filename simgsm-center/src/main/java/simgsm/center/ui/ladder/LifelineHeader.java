package simgsm.center.ui.ladder;

import java.awt.Dimension;
import java.awt.Graphics2D;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/** The names of the lifelines, above each column of the ladder. */
final class LifelineHeader extends PaintedComponent {

    private Lifelines lifelines = Lifelines.NONE;
    private final LadderList list;
    private double heightUnits = LadderDrawing.HEAD_UNITS;

    void show(Lifelines newLifelines) {
        lifelines = newLifelines;
        revalidate();
        repaint();
    }

    void setLow(boolean low) {
        heightUnits = low ? LadderDrawing.LOW_HEAD_UNITS : LadderDrawing.HEAD_UNITS;
    }

    LifelineHeader(LadderList list) {
        super(AccessibleRole.COLUMN_HEADER);
        this.list = list;
    }

    @Override
    public Dimension getPreferredSize() {
        int width = list.columns() > 1 ? list.getPreferredSize().width : lifelines.leastWidth();
        return new Dimension(width, Theme.px(heightUnits));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        g.setColor(Theme.color(Ink.CARD));
        g.fillRect(0, 0, getWidth(), getHeight());
        int column = list.columns() > 1 ? Math.max(1, list.columnWidth()) : getWidth();
        for (int x = 0; x + column <= getWidth(); x += column) {
            Graphics2D place = (Graphics2D) g.create(x, 0, column, getHeight());
            new LadderDrawing(new GraphicsCanvas(place), lifelines, column / Theme.zoom()).heads(heightUnits);
            place.dispose();
        }
    }

    @Override
    protected String spoken() {
        return String.join(", ", lifelines.names());
    }
}
