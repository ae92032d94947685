package simgsm.center.ui.ladder;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.util.Comparator;
import javax.accessibility.AccessibleRole;
import javax.swing.ToolTipManager;
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
        ToolTipManager.sharedInstance().registerComponent(this);
    }

    /** The whole name, because the one that is drawn may be cut. */
    @Override
    public String getToolTipText(MouseEvent event) {
        int column = list.columns() > 1 ? Math.max(1, list.columnWidth()) : getWidth();
        double x = event.getX() % column / Theme.zoom();
        double width = column / Theme.zoom();
        return lifelines.names().stream()
                .min(Comparator.comparingDouble(name -> Math.abs(lifelines.x(name, width) - x)))
                .orElseThrow();
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
