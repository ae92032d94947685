package simgsm.ui;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Insets;
import javax.swing.border.Border;

/** Empty space in units of the theme, so that it grows with the zoom. */
record Padding(int top, int left, int bottom, int right) implements Border {
    @Override
    public Insets getBorderInsets(Component c) {
        return Theme.insets(top, left, bottom, right);
    }

    @Override
    public boolean isBorderOpaque() {
        return false;
    }

    @Override
    public void paintBorder(Component c, Graphics g, int x, int y, int width, int height) {
        // Space only.
    }
}
