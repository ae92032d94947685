package simgsm.center.ui.ladder;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.ListCellRenderer;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.Theme;

/** Paints a rung of the ladder. */
final class LadderCell extends JLabel implements ListCellRenderer<LadderRow> {
    private Lifelines lifelines = Lifelines.NONE;
    private double heightUnits = LadderDrawing.RUNG_UNITS;
    private LadderRow row;
    /** The part of the width that is in view. */
    private Rectangle seen = new Rectangle();

    private boolean isSelected;
    private boolean isFocused;

    void show(Lifelines newLifelines) {
        lifelines = newLifelines;
    }

    void setLow(boolean low) {
        heightUnits = low ? LadderDrawing.LOW_RUNG_UNITS : LadderDrawing.RUNG_UNITS;
    }

    @Override
    public Component getListCellRendererComponent(
            JList<? extends LadderRow> list, LadderRow value, int index, boolean selected, boolean focused) {
        row = value;
        isSelected = selected;
        isFocused = focused;
        boolean isOneColumn = list.getLayoutOrientation() == JList.VERTICAL;
        seen = isOneColumn ? list.getVisibleRect() : new Rectangle(list.getFixedCellWidth(), 0);
        setText(value == null ? "" : value.toString());
        return this;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(lifelines.leastWidth(), Theme.px(heightUnits));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        if (row == null) {
            return;
        }
        Graphics2D g = Drawing.on(graphics);
        try {
            double zoom = Theme.zoom();
            new LadderDrawing(new GraphicsCanvas(g), lifelines, getWidth() / zoom, seen.x / zoom, seen.getMaxX() / zoom)
                    .rung(row, getHeight() / zoom, isSelected ? Ink.ACCENT_WASH : Ink.CARD);
            if (isFocused) {
                g.setColor(Theme.color(Ink.ACCENT));
                g.setStroke(Theme.hairline());
                g.draw(Drawing.round(1, 1, getWidth() - 3, getHeight() - 3, Theme.exact(Theme.HALF)));
            }
        } finally {
            g.dispose();
        }
    }
}
