package simgsm.ui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;

/** Signal strength as bars of growing height; the phone's display uses the same painter. */
public final class SignalBars extends PaintedComponent {
    public static final int BARS = 5;

    private final String subject;
    private int level;

    /** @param subject for assistive technology: "Signal" */
    public SignalBars(String subject) {
        super(AccessibleRole.LABEL);
        this.subject = subject;
        setToolTipText(subject);
    }

    /** @param newLevel 0 to {@link #BARS} */
    public void show(int newLevel) {
        if (newLevel < 0 || newLevel > BARS) {
            throw new IllegalArgumentException("signal level " + newLevel + " is not 0 to " + BARS);
        }
        if (newLevel != level) {
            change(() -> level = newLevel);
        }
    }

    @Override
    protected String spoken() {
        return subject + ": " + level + "/" + BARS;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(26), Theme.px(16));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double tall = Math.min(height, Theme.exact(14));
        double wide = Math.min(width, Theme.exact(24));
        paint(g, 0, (height - tall) / 2, wide, tall, level, Theme.color(Ink.TEXT), Theme.color(Ink.LINE));
    }

    /** Paints the bars into a box, edges on device pixels. */
    public static void paint(
            Graphics2D g, double x, double y, double width, double height, int level, Color on, Color off) {
        double step = width / BARS;
        for (int i = 0; i < BARS; i++) {
            double tall = height * (i + 2) / (BARS + 1);
            g.setColor(i < level ? on : off);
            Drawing.fillCrisp(g, x + i * step, y + height - tall, step * 0.64, tall);
        }
    }
}
