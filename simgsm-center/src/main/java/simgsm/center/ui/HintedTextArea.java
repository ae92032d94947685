package simgsm.center.ui;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import javax.swing.JTextArea;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;

/** A text area that shows a hint while it is empty, which takes no room for a label. */
final class HintedTextArea extends JTextArea {
    private final String hint;

    HintedTextArea(String hint) {
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
            g.setFont(Theme.base());
            g.setColor(Theme.color(Ink.QUIET));
            g.drawString(
                    Drawing.fitted(Theme.base(), hint, getWidth() - in.left - in.right - Theme.px(2)),
                    in.left + Theme.px(2),
                    in.top + g.getFontMetrics().getAscent());
        } finally {
            g.dispose();
        }
    }
}
