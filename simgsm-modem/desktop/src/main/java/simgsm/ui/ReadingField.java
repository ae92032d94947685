package simgsm.ui;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import javax.swing.BoundedRangeModel;
import javax.swing.JTextField;

/** A read-only field to copy from; an ellipsis at an edge marks text beyond it. */
public final class ReadingField extends JTextField {
    private static final String CUT = "\u2026";

    public ReadingField(int columns) {
        super(columns);
        setEditable(false);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        BoundedRangeModel seen = getHorizontalVisibility();
        Insets in = getInsets();
        int room = getWidth() - in.left - in.right;
        Graphics2D g = Drawing.on(graphics);
        try {
            int mark = Drawing.width(getFont(), CUT);
            if (seen.getValue() > seen.getMinimum()) {
                mark(g, in.left, mark);
            }
            if (seen.getValue() + room < Drawing.width(getFont(), getText())) {
                mark(g, in.left + room - mark, mark);
            }
        } finally {
            g.dispose();
        }
    }

    /** Covers the text at the edge. */
    private void mark(Graphics2D g, int x, int width) {
        Insets in = getInsets();
        g.setColor(getBackground());
        g.fillRect(x, in.top, width, getHeight() - in.top - in.bottom);
        g.setColor(getForeground());
        g.setFont(getFont());
        var metrics = g.getFontMetrics();
        g.drawString(CUT, x, (getHeight() - metrics.getHeight()) / 2 + metrics.getAscent());
    }
}
