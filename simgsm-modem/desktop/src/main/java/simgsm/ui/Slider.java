package simgsm.ui;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import javax.swing.JSlider;
import javax.swing.KeyStroke;
import javax.swing.plaf.basic.BasicSliderUI;
import simgsm.draw.Ink;

/**
 * A slider: a track, coloured from the neutral value to the current one, and a knob. The mouse drags it; the arrows
 * and the wheel move it by 1, the Page keys by 5; Home and a double click set the neutral value. Nimbus's slider
 * cannot be made without a display.
 */
public final class Slider extends JSlider {
    private static final double KNOB = 6;
    private static final int PAGE = 5;

    private final int neutral;
    private boolean isShown;

    /**
     * A slider at its neutral value.
     *
     * @param moved run after every change, on the event thread
     */
    public Slider(int least, int most, int neutral, Runnable moved) {
        super(least, most, neutral);
        this.neutral = neutral;
        setOpaque(false);
        addChangeListener(event -> {
            if (!isShown) {
                moved.run();
            }
        });
        bindStep(KeyEvent.VK_LEFT, -1);
        bindStep(KeyEvent.VK_DOWN, -1);
        bindStep(KeyEvent.VK_RIGHT, 1);
        bindStep(KeyEvent.VK_UP, 1);
        bindStep(KeyEvent.VK_PAGE_DOWN, -PAGE);
        bindStep(KeyEvent.VK_PAGE_UP, PAGE);
        bind(KeyEvent.VK_HOME, "neutral", () -> setValue(neutral));
        bind(KeyEvent.VK_END, "most", () -> setValue(getMaximum()));
        addMouseWheelListener(event -> setValue(getValue() - event.getWheelRotation()));
    }

    private void bindStep(int key, int change) {
        bind(key, "step." + change, () -> setValue(getValue() + change));
    }

    private void bind(int key, String id, Runnable task) {
        new UserAction(id, id, task).bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke(key, 0));
    }

    @Override
    public void updateUI() {
        setUI(new BasicSliderUI(this) {
            @Override
            protected TrackListener createTrackListener(JSlider slider) {
                return new Pointing();
            }

            /** Moves the knob at once to the pressed point of the track. */
            private final class Pointing extends TrackListener {
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

                @Override
                public void mouseReleased(MouseEvent event) {}
            }
        });
    }

    /** Sets the value without running the task, after a change from elsewhere. */
    public void show(int shown) {
        isShown = true;
        setValue(shown);
        isShown = false;
    }

    @Override
    public Dimension getPreferredSize() {
        return isPreferredSizeSet() ? super.getPreferredSize() : new Dimension(Theme.px(56), Theme.px(22));
    }

    /** The knob's centre for a value, in pixels from the left. */
    private double at(int place) {
        double edge = Theme.exact(KNOB + 2);
        return edge + (getWidth() - 2 * edge) * (place - getMinimum()) / (getMaximum() - getMinimum());
    }

    private void pointTo(double x) {
        double edge = Theme.exact(KNOB + 2);
        double share = (x - edge) / Math.max(1, getWidth() - 2 * edge);
        setValue((int) Math.round(getMinimum() + share * (getMaximum() - getMinimum())));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        int value = getValue();
        Graphics2D g = Drawing.on(graphics);
        try {
            double middle = getHeight() / 2.0;
            double thick = Theme.exact(4);
            bar(g, at(getMinimum()), at(getMaximum()), middle, thick, Ink.LINE);
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
}
