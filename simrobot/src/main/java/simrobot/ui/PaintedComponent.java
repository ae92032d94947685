package simrobot.ui;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.accessibility.AccessibleRole;
import simgsm.ui.Drawing;
import simgsm.ui.SpokenComponent;

/** A small painted component that asks the theme whenever it paints, and says what it shows. */
public abstract class PaintedComponent extends SpokenComponent {
    private String spoken = "";

    public PaintedComponent(String name) {
        super(AccessibleRole.LABEL);
        setName(name);
    }

    /** What it shows, for assistive technology; a change is told and repaints. */
    protected final void say(String newSpoken) {
        if (!newSpoken.equals(spoken)) {
            String before = spoken;
            spoken = newSpoken;
            tellSpoken(before, spoken);
            repaint();
        }
    }

    /** In logical pixels, at the theme's present zoom. */
    protected abstract Dimension preferred();

    protected abstract void paint(Graphics2D g, double width, double height);

    @Override
    public final Dimension getPreferredSize() {
        return preferred();
    }

    @Override
    public Dimension getMinimumSize() {
        return preferred();
    }

    @Override
    protected final void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            paint(g, getWidth(), getHeight());
        } finally {
            g.dispose();
        }
    }

    @Override
    protected final String spoken() {
        return spoken;
    }
}
