package simgsm.ui;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.Icon;
import simgsm.ui.Theme.Ink;

/** An icon that is drawn by code on a square of 16 units, in its component's colour, at any zoom and scale. */
public abstract class CodeIcon implements Icon {
    /** The side of the square on which {@link #draw} works. */
    public static final double SIDE = 16;

    private final double units;

    protected CodeIcon() {
        this(SIDE);
    }

    /** @param units the icon's side on the screen */
    protected CodeIcon(double units) {
        this.units = units;
    }

    @Override
    public int getIconWidth() {
        return Theme.px(units);
    }

    @Override
    public int getIconHeight() {
        return Theme.px(units);
    }

    @Override
    public void paintIcon(Component c, Graphics graphics, int x, int y) {
        Graphics2D g = Drawing.on(graphics);
        try {
            g.translate(x, y);
            g.scale(getIconWidth() / SIDE, getIconHeight() / SIDE);
            g.setColor(
                    c == null || c.isEnabled()
                            ? (c == null ? Ink.TEXT.color() : c.getForeground())
                            : Ink.DISABLED.color());
            draw(g);
        } finally {
            g.dispose();
        }
    }

    /** Draws on the square from (0, 0) to (16, 16) in the colour that is set. */
    protected abstract void draw(Graphics2D g);
}
