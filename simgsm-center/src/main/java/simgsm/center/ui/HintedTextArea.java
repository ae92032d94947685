package simgsm.center.ui;

import java.awt.Graphics;
import java.awt.Insets;
import javax.swing.JTextArea;
import simgsm.ui.HintedTextField;
import simgsm.ui.Theme;

/** A text area that shows a hint while it is empty, which saves a label. */
final class HintedTextArea extends JTextArea {
    private final String hint;

    HintedTextArea(String hint) {
        this.hint = hint;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        Insets in = getInsets();
        int baseline = in.top + getFontMetrics(getFont()).getAscent();
        HintedTextField.paintHint(graphics, this, hint, in.left + Theme.px(2), baseline);
    }
}
