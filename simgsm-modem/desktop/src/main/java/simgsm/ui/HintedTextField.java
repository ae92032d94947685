package simgsm.ui;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import javax.swing.JTextField;
import simgsm.draw.Ink;

/** A text field that shows a hint while it is empty, which takes no room for a label. */
public final class HintedTextField extends JTextField {
    private static final int COLUMNS = 6;

    private final String hint;

    public HintedTextField(String hint) {
        super(COLUMNS);
        this.hint = hint;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        if (getDocument().getLength() > 0) {
            return;
        }
        Graphics2D g = Drawing.on(graphics);
        try {
            Insets in = getInsets();
            g.setFont(getFont());
            g.setColor(Theme.color(Ink.QUIET));
            int baseline = (getHeight() - g.getFontMetrics().getHeight()) / 2
                    + g.getFontMetrics().getAscent();
            g.drawString(Drawing.fitted(getFont(), hint, getWidth() - in.left - in.right), in.left, baseline);
        } finally {
            g.dispose();
        }
    }
}
