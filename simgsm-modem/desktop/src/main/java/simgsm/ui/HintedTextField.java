package simgsm.ui;

import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import javax.swing.JTextField;
import javax.swing.text.JTextComponent;
import simgsm.draw.Ink;

/** A text field that shows a hint while it is empty, instead of a label. */
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
        Insets in = getInsets();
        FontMetrics metrics = getFontMetrics(getFont());
        int baseline = (getHeight() - metrics.getHeight()) / 2 + metrics.getAscent();
        paintHint(graphics, this, hint, in.left, baseline);
    }

    /** Paints the hint of an empty field. @param x start of the text; @param baseline in pixels */
    public static void paintHint(Graphics graphics, JTextComponent field, String hint, int x, int baseline) {
        if (field.getDocument().getLength() == 0) {
            Graphics2D g = Drawing.on(graphics);
            g.setFont(field.getFont());
            g.setColor(Theme.color(Ink.QUIET));
            g.drawString(
                    Drawing.fitted(field.getFont(), hint, field.getWidth() - x - field.getInsets().right), x, baseline);
            g.dispose();
        }
    }
}
