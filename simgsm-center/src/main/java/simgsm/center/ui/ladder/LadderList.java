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

/**
 * The list of messages. Fills the window's width; scrolls when the lifelines would be too close. A low and wide list
 * shows the messages in columns from left to right.
 */
final class LadderList extends JList<LadderRow> {
    private static final int ROWS_AT_FIRST = 8;

    private final LadderModel model;
    private final LadderCell cell;
    private final String empty;
    private int columns = 1;
    private int columnWidth;

    /** @param empty shown before the first message */
    LadderList(LadderModel model, LadderCell cell, String empty) {
        super(model);
        this.model = model;
        this.cell = cell;
        this.empty = empty;
        setCellRenderer(cell);
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    }

    /**
     * @param newColumns number of visible columns
     * @param newWidth of each, in pixels; without effect for one
     */
    void setColumns(int newColumns, int newWidth) {
        columns = newColumns;
        columnWidth = newWidth;
        setLayoutOrientation(columns > 1 ? VERTICAL_WRAP : VERTICAL);
        fit();
        arrange();
    }

    /** Arranges the columns for the new height. */
    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        arrange();
    }

    /** Derives the number of rows per column from the height. */
    private void arrange() {
        int rows = Math.max(1, getHeight() / Math.max(1, getFixedCellHeight()));
        setVisibleRowCount(columns > 1 ? rows : ROWS_AT_FIRST);
        model.arrange(columns, rows);
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return columns > 1 || super.getScrollableTracksViewportHeight();
    }

    int columns() {
        return columns;
    }

    /** Width of each of several columns, in pixels. */
    int columnWidth() {
        return columnWidth;
    }

    void fit() {
        Dimension size = cell.getPreferredSize();
        setFixedCellWidth(columns > 1 ? columnWidth : size.width);
        setFixedCellHeight(size.height);
        setBackground(Theme.color(Ink.CARD));
        revalidate();
        repaint();
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        int index = locationToIndex(event.getPoint());
        LadderRow row = index < 0 ? null : getModel().getElementAt(index);
        return row == null ? null : row.toString();
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return columns > 1
                ? super.getScrollableTracksViewportWidth()
                : getParent() == null || getParent().getWidth() >= getFixedCellWidth();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        Graphics2D g = Drawing.on(graphics);
        try {
            g.setColor(Theme.color(Ink.LINE));
            for (int x = columnWidth; columns > 1 && x < getWidth(); x += columnWidth) {
                g.fillRect(x, 0, 1, getHeight());
            }
            if (getModel().getSize() == 0) {
                g.setColor(Theme.color(Ink.QUIET));
                Drawing.centred(g, empty, Theme.base(), getWidth() / 2.0, Math.min(Theme.exact(60), getHeight() / 2.0));
            }
        } finally {
            g.dispose();
        }
    }
}
