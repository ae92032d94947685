package simgsm.ui;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;

/** A sequence of telephone keys as keycaps, the newest at the right; a fault is underlined at its position. */
public final class Keycaps extends PaintedComponent {
    private static final double CAP_UNITS = 22;
    private static final double STEP_UNITS = 25;
    private static final double HEIGHT_UNITS = 34;

    private final String subject;
    private String keys = "";
    private int faultPosition;

    /** @param subject for assistive technology: "Keys of the order" */
    public Keycaps(String subject) {
        super(AccessibleRole.LABEL);
        this.subject = subject;
    }

    /**
     * Shows keys.
     *
     * @param newKeys telephone keys without blanks
     * @param newFaultPosition counted from 1; 0 for none; number of keys + 1 for a missing key
     */
    public void show(String newKeys, int newFaultPosition) {
        if (!newKeys.equals(keys) || newFaultPosition != faultPosition) {
            change(() -> keys = newKeys);
            faultPosition = newFaultPosition;
            revalidate();
            repaint();
        }
    }

    public String keys() {
        return keys;
    }

    public int faultPosition() {
        return faultPosition;
    }

    @Override
    public Dimension getPreferredSize() {
        int places = Math.max(1, Math.max(keys.length(), faultPosition));
        return new Dimension(Theme.px(places * STEP_UNITS), Theme.px(HEIGHT_UNITS));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(4 * STEP_UNITS), Theme.px(HEIGHT_UNITS));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        int places = Math.max(keys.length(), faultPosition);
        double gap = Theme.exact(STEP_UNITS - CAP_UNITS);
        int fits = Math.max(1, (int) ((width + gap) / Theme.exact(STEP_UNITS)));
        int first = Math.max(0, places - fits);
        double top = (height - Theme.exact(HEIGHT_UNITS)) / 2;
        for (int i = first; i < places; i++) {
            double x = (i - first) * Theme.exact(STEP_UNITS);
            if (i < keys.length()) {
                paintCap(g, String.valueOf(keys.charAt(i)), x, top, i + 1 == faultPosition);
            }
            if (i + 1 == faultPosition) {
                underline(g, x, top + Theme.exact(CAP_UNITS + 6));
            }
        }
    }

    private static void paintCap(Graphics2D g, String key, double x, double top, boolean faulty) {
        double size = Theme.exact(CAP_UNITS);
        double tall = Theme.exact(CAP_UNITS + 3);
        double radius = Theme.exact(5);
        Ink line = faulty ? Ink.DANGER : Ink.CONTROL_LINE;
        g.setColor(Theme.color(line));
        g.fill(Drawing.round(x, top, size, tall, radius));
        g.setColor(Theme.color(faulty ? Ink.DANGER_WASH : Ink.CARD));
        double edge = Theme.exact(1);
        g.fill(Drawing.round(x + edge, top + edge, size - 2 * edge, tall - Theme.exact(3.5), radius - edge));
        g.setColor(Theme.color(Ink.TEXT));
        Drawing.centred(g, key, Theme.monoStrong(), x + size / 2, top + tall / 2 - edge);
    }

    private static void underline(Graphics2D g, double x, double y) {
        var wave = new Path2D.Double();
        double step = Theme.exact(CAP_UNITS) / 6;
        wave.moveTo(x, y);
        for (int i = 1; i <= 6; i++) {
            wave.lineTo(x + i * step, y + (i % 2 == 0 ? 0 : Theme.exact(3)));
        }
        g.setColor(Theme.color(Ink.DANGER));
        g.setStroke(Theme.line());
        g.draw(wave);
    }

    @Override
    protected String spoken() {
        return subject + ": " + keys;
    }
}
