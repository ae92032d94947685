package simgsm.classroom.ui;

import java.awt.Dimension;
import java.awt.Insets;
import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.plaf.basic.BasicHTML;
import javax.swing.text.View;
import simgsm.draw.SvgCanvas;

/** A button in a column that wraps its text to the column's width. */
final class WrappingButton extends JButton {
    WrappingButton(Action action) {
        super(action);
    }

    @Override
    public void setText(String text) {
        String escaped = text == null ? "" : SvgCanvas.escaped(text);
        super.setText("<html><body style='text-align:center'>" + escaped + "</body></html>");
    }

    /** Returns the height of the text at the current width. */
    @Override
    public Dimension getPreferredSize() {
        if (getClientProperty(BasicHTML.propertyKey) instanceof View text && getParent() != null) {
            Insets around = getParent().getInsets();
            Insets in = getInsets();
            int width = getParent().getWidth() - around.left - around.right - in.left - in.right;
            if (width > 0) {
                text.setSize(width, 0);
            }
        }
        return super.getPreferredSize();
    }
}
