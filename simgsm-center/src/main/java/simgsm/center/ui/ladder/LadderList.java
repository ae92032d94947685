package simgsm.center.ui.ladder;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import javax.swing.JList;
import javax.swing.ListSelectionModel;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;

/** The list of messages. Fills the window's width; scrolls when the lifelines would be too close. */
final class LadderList extends JList<LadderRow> {
    private final LadderCell cell;
    private final String empty;

    /** @param empty is shown before the first message */
    LadderList(LadderModel model, LadderCell cell, String empty) {
        super(model);
        this.cell = cell;
        this.empty = empty;
        setCellRenderer(cell);
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    }

    void fit() {
        Dimension size = cell.getPreferredSize();
        setFixedCellWidth(size.width);
        setFixedCellHeight(size.height);
        setBackground(Theme.color(Ink.CARD));
        revalidate();
        repaint();
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        int index = locationToIndex(event.getPoint());
        return index < 0 ? null : getModel().getElementAt(index).toString();
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return getParent() == null || getParent().getWidth() >= getFixedCellWidth();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        if (getModel().getSize() == 0) {
            Graphics2D g = Drawing.on(graphics);
            try {
                g.setColor(Theme.color(Ink.QUIET));
                Drawing.centred(g, empty, Theme.base(), getWidth() / 2.0, Theme.exact(60));
            } finally {
                g.dispose();
            }
        }
    }
}
