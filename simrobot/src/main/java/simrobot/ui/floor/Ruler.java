package simrobot.ui.floor;

import java.awt.Graphics2D;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;
import simrobot.ui.PoseTexts;
import simrobot.world.Position;

/**
 * Measures from one place to another.
 *
 * @param from where it begins
 * @param to where it ends
 */
record Ruler(Position from, Position to) {
    double meters() {
        return Math.hypot(to.xMeters() - from.xMeters(), to.yMeters() - from.yMeters());
    }

    /** Anticlockwise from +X. */
    double radians() {
        return Math.atan2(to.yMeters() - from.yMeters(), to.xMeters() - from.xMeters());
    }

    String text() {
        return PoseTexts.meters(meters()) + " m  " + PoseTexts.degrees(radians()) + "\u00b0";
    }

    private String parts() {
        return "\u0394x " + PoseTexts.meters(to.xMeters() - from.xMeters()) + "  \u0394y "
                + PoseTexts.meters(to.yMeters() - from.yMeters());
    }

    Ruler movedBy(boolean begin, double dx, double dy) {
        return begin
                ? new Ruler(new Position(from.xMeters() + dx, from.yMeters() + dy), to)
                : new Ruler(from, new Position(to.xMeters() + dx, to.yMeters() + dy));
    }

    void paint(Graphics2D g, Viewport view) {
        double x1 = view.screenX(from.xMeters());
        double y1 = view.screenY(from.yMeters());
        double x2 = view.screenX(to.xMeters());
        double y2 = view.screenY(to.yMeters());
        g.setColor(Theme.color(Ink.CARD, 0.8));
        g.setStroke(Theme.stroke(5));
        Drawing.line(g, x1, y1, x2, y2);
        g.setColor(Theme.color(Ink.ACCENT));
        g.setStroke(Theme.stroke(1.8));
        Drawing.line(g, x1, y1, x2, y2);
        ticks(g, view, x1, y1);
        label(g, view, x2, y2);
    }

    /** Across both ends, and a short one every metre while there is room. */
    private void ticks(Graphics2D g, Viewport view, double x1, double y1) {
        double ux = Math.cos(radians());
        double uy = -Math.sin(radians());
        double step = view.pixelsPerMeter() >= Theme.exact(12) ? 1 : Math.max(1, meters());
        for (double at = 0; at < meters(); at += step) {
            tick(
                    g,
                    x1 + ux * at * view.pixelsPerMeter(),
                    y1 + uy * at * view.pixelsPerMeter(),
                    ux,
                    uy,
                    at == 0 ? 8 : 4);
        }
        tick(g, view.screenX(to.xMeters()), view.screenY(to.yMeters()), ux, uy, 8);
    }

    private static void tick(Graphics2D g, double x, double y, double ux, double uy, double units) {
        double arm = Theme.exact(units);
        Drawing.line(g, x - uy * arm, y + ux * arm, x + uy * arm, y - ux * arm);
    }

    private void label(Graphics2D g, Viewport view, double x, double y) {
        double width = Math.max(Drawing.width(Theme.monoStrong(), text()), Drawing.width(Theme.monoSmall(), parts()))
                + Theme.exact(16);
        double height = Theme.exact(40);
        double left = clamp(x + Theme.exact(14), view.width() - width - Theme.exact(4));
        double top = clamp(y + Theme.exact(10), view.height() - height - Theme.exact(4));
        g.setColor(Theme.color(Ink.CARD));
        g.fill(Drawing.round(left, top, width, height, Theme.exact(Theme.CONTROL_RADIUS)));
        g.setColor(Theme.color(Ink.ACCENT));
        g.setStroke(Theme.hairline());
        g.draw(Drawing.round(left, top, width, height, Theme.exact(Theme.CONTROL_RADIUS)));
        g.setColor(Theme.color(Ink.TEXT));
        Drawing.centred(g, text(), Theme.monoStrong(), left + width / 2, top + Theme.exact(13));
        g.setColor(Theme.color(Ink.QUIET));
        Drawing.centred(g, parts(), Theme.monoSmall(), left + width / 2, top + Theme.exact(29));
    }

    private static double clamp(double value, double most) {
        return Math.max(Theme.exact(4), Math.min(most, value));
    }
}
