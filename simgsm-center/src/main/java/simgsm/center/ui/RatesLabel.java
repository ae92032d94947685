package simgsm.center.ui;

import java.awt.Dimension;
import java.awt.Graphics;
import javax.swing.JLabel;
import javax.swing.SwingConstants;

/** A label that is hidden when it does not fit. */
final class RatesLabel extends JLabel {
    RatesLabel() {
        setHorizontalAlignment(SwingConstants.TRAILING);
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(0, super.getMinimumSize().height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        if (getPreferredSize().width <= getWidth()) {
            super.paintComponent(graphics);
        }
    }
}
