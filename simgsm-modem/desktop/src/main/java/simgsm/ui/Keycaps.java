package simgsm.ui;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;

/**
 * A sequence of telephone keys as keycaps in one row or more; a fault is underlined at its position. Keys that do not
 * fit become smaller, down to {@link #LEAST_SCALE}; if they still do not fit, an ellipsis replaces the first ones.
 */
public final class Keycaps extends PaintedComponent {
    private static final double CAP_UNITS = 22;
    private static final double STEP_UNITS = 25;
    private static final double HEIGHT_UNITS = 34;
    private static final double LEAST_SCALE = 0.6;
    private static final double SCALE_STEP = 0.1;
    private static final int PREFERRED_ROWS = 2;

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

    private int places() {
        return Math.max(1, Math.max(keys.length(), faultPosition));
    }

    /** One row, or two if the keys do not fit in the current width. */
    @Override
    public Dimension getPreferredSize() {
        boolean isOneRow = getWidth() == 0 || places() <= Grid.inRow(getWidth(), 1);
        return new Dimension(Theme.px(places() * STEP_UNITS), Theme.px((isOneRow ? 1 : PREFERRED_ROWS) * HEIGHT_UNITS));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(4 * STEP_UNITS), Theme.px(HEIGHT_UNITS));
    }

    /** Number, first index and scale of the keys shown. */
    record Grid(int inRow, int rows, int first, double scale) {
        static Grid of(int places, double width, double height) {
            double scale = 1;
            while (inRow(width, scale) * rows(height, scale) < places && scale > LEAST_SCALE) {
                scale = Math.max(LEAST_SCALE, scale - SCALE_STEP);
            }
            int inRow = inRow(width, scale);
            int rows = rows(height, scale);
            // The ellipsis replaces the first key.
            int first = inRow * rows < places ? places - inRow * rows + 1 : 0;
            return new Grid(inRow, rows, first, scale);
        }

        static int inRow(double width, double scale) {
            double gap = Theme.exact(STEP_UNITS - CAP_UNITS) * scale;
            return Math.max(1, (int) ((width + gap) / (Theme.exact(STEP_UNITS) * scale)));
        }

        private static int rows(double height, double scale) {
            return Math.max(1, (int) Math.round(Math.floor(height / (Theme.exact(HEIGHT_UNITS) * scale) + 0.01)));
        }
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        int places = Math.max(keys.length(), faultPosition);
        Grid grid = Grid.of(places, width, height);
        int shift = grid.first() > 0 ? 1 : 0;
        int usedRows = (int) Math.ceil((double) (places - grid.first() + shift) / grid.inRow());
        g.translate(0, (height - usedRows * Theme.exact(HEIGHT_UNITS) * grid.scale()) / 2);
        g.scale(grid.scale(), grid.scale());
        if (shift > 0) {
            g.setColor(Theme.color(Ink.QUIET));
            Drawing.centred(g, "\u2026", Theme.monoStrong(), Theme.exact(CAP_UNITS / 2), Theme.exact(CAP_UNITS / 2));
        }
        for (int i = grid.first(); i < places; i++) {
            int cell = i - grid.first() + shift;
            double x = cell % grid.inRow() * Theme.exact(STEP_UNITS);
            double top = cell / grid.inRow() * Theme.exact(HEIGHT_UNITS);
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
