package simgsm.ui;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.accessibility.AccessibleState;
import javax.accessibility.AccessibleStateSet;
import javax.accessibility.AccessibleValue;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import simgsm.draw.Ink;

/**
 * A slider: a track, coloured from the neutral value to the current one, and a knob. The mouse drags it; the arrows and the
 * wheel move it by 1, the Page keys by 5; Home and a double click set the neutral value. (Under Nimbus a JSlider cannot be
 * made without a display.)
 */
public final class Slider extends JComponent implements Accessible {
    private static final double KNOB = 6;
    private static final int PAGE = 5;

    private final int least;
    private final int most;
    private final int neutral;
    private final transient Runnable moved;
    private int value;

    /**
     * A slider at its neutral value.
     *
     * @param moved run after every change, on the event thread
     */
    public Slider(int least, int most, int neutral, Runnable moved) {
        this.least = least;
        this.most = most;
        this.neutral = neutral;
        this.value = neutral;
        this.moved = moved;
        setFocusable(true);
        bind(KeyEvent.VK_LEFT, "less", () -> setValue(value - 1));
        bind(KeyEvent.VK_DOWN, "less", () -> setValue(value - 1));
        bind(KeyEvent.VK_RIGHT, "more", () -> setValue(value + 1));
        bind(KeyEvent.VK_UP, "more", () -> setValue(value + 1));
        bind(KeyEvent.VK_PAGE_DOWN, "much.less", () -> setValue(value - PAGE));
        bind(KeyEvent.VK_PAGE_UP, "much.more", () -> setValue(value + PAGE));
        bind(KeyEvent.VK_HOME, "neutral", () -> setValue(neutral));
        bind(KeyEvent.VK_END, "most", () -> setValue(most));
        Mouse mouse = new Mouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(event -> setValue(value - event.getWheelRotation()));
        PaintedComponent.repaintOnFocus(this);
    }

    /** Sets the value without running the task: what the slider shows has changed by itself. */
    public void show(int shown) {
        int next = Math.max(least, Math.min(most, shown));
        if (next != value) {
            value = next;
            repaint();
        }
    }

    private void bind(int key, String id, Runnable task) {
        new UserAction(id, id, task).bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke(key, 0));
    }

    public int value() {
        return value;
    }

    /** Sets the value, limited to its range. */
    public void setValue(int wanted) {
        int next = Math.max(least, Math.min(most, wanted));
        if (next != value) {
            int before = value;
            value = next;
            if (accessibleContext != null) {
                accessibleContext.firePropertyChange(AccessibleContext.ACCESSIBLE_VALUE_PROPERTY, before, next);
            }
            repaint();
            moved.run();
        }
    }

    @Override
    public Dimension getPreferredSize() {
        return isPreferredSizeSet() ? super.getPreferredSize() : new Dimension(Theme.px(56), Theme.px(22));
    }

    /** The knob's centre for a value, in pixels from the left. */
    private double at(int place) {
        double edge = Theme.exact(KNOB + 2);
        return edge + (getWidth() - 2 * edge) * (place - least) / (most - least);
    }

    private void pointTo(double x) {
        double edge = Theme.exact(KNOB + 2);
        double share = (x - edge) / Math.max(1, getWidth() - 2 * edge);
        setValue((int) Math.round(least + share * (most - least)));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            double middle = getHeight() / 2.0;
            double thick = Theme.exact(4);
            bar(g, at(least), at(most), middle, thick, Ink.LINE);
            bar(g, Math.min(at(neutral), at(value)), Math.max(at(neutral), at(value)), middle, thick, Ink.ACCENT);
            g.setColor(Theme.color(Ink.CONTROL_LINE));
            Drawing.vertical(g, at(neutral) - Theme.exact(0.5), middle - Theme.exact(6), middle + Theme.exact(6));
            double radius = Theme.exact(KNOB);
            var knob = new Ellipse2D.Double(at(value) - radius, middle - radius, 2 * radius, 2 * radius);
            g.setColor(Theme.color(Ink.CARD));
            g.fill(knob);
            g.setStroke(hasFocus() ? Theme.stroke(2.4) : Theme.line());
            g.setColor(Theme.color(hasFocus() || value != neutral ? Ink.ACCENT : Ink.CONTROL_LINE));
            g.draw(knob);
        } finally {
            g.dispose();
        }
    }

    private static void bar(Graphics2D g, double from, double to, double middle, double thick, Ink ink) {
        g.setColor(Theme.color(ink));
        g.fill(Drawing.round(from, middle - thick / 2, Math.max(0, to - from), thick, thick / 2));
    }

    private final class Mouse extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent event) {
            requestFocusInWindow();
            if (event.getClickCount() == 2) {
                setValue(neutral);
            } else {
                pointTo(event.getX());
            }
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            pointTo(event.getX());
        }
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new SliderContext();
        }
        return accessibleContext;
    }

    private final class SliderContext extends AccessibleJComponent implements AccessibleValue {
        @Override
        public AccessibleRole getAccessibleRole() {
            return AccessibleRole.SLIDER;
        }

        @Override
        public AccessibleStateSet getAccessibleStateSet() {
            AccessibleStateSet states = super.getAccessibleStateSet();
            states.add(AccessibleState.HORIZONTAL);
            return states;
        }

        @Override
        public AccessibleValue getAccessibleValue() {
            return this;
        }

        @Override
        public Number getCurrentAccessibleValue() {
            return value;
        }

        @Override
        public boolean setCurrentAccessibleValue(Number wanted) {
            setValue(wanted.intValue());
            return true;
        }

        @Override
        public Number getMinimumAccessibleValue() {
            return least;
        }

        @Override
        public Number getMaximumAccessibleValue() {
            return most;
        }
    }
}
