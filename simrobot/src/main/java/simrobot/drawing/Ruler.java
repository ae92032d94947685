package simrobot.drawing;

import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.draw.Outline;
import simrobot.world.Position;

/** A measurement of distance and direction between two places. */
public record Ruler(Position from, Position to) {
    public double meters() {
        return Math.hypot(to.xMeters() - from.xMeters(), to.yMeters() - from.yMeters());
    }

    /** Anticlockwise from +X. */
    double radians() {
        return Math.atan2(to.yMeters() - from.yMeters(), to.xMeters() - from.xMeters());
    }

    public String text() {
        return NumberTexts.meters(meters()) + " m  " + NumberTexts.degrees(radians()) + "\u00b0";
    }

    private String parts() {
        return "\u0394x " + NumberTexts.meters(to.xMeters() - from.xMeters()) + "  \u0394y "
                + NumberTexts.meters(to.yMeters() - from.yMeters());
    }

    /**
     * The ruler with one end moved.
     *
     * @param begin true to move {@code from}
     */
    public Ruler movedBy(boolean begin, double dxMeters, double dyMeters) {
        return begin
                ? new Ruler(new Position(from.xMeters() + dxMeters, from.yMeters() + dyMeters), to)
                : new Ruler(from, new Position(to.xMeters() + dxMeters, to.yMeters() + dyMeters));
    }

    public void paint(Canvas g, Viewport view) {
        double x1 = view.screenX(from.xMeters());
        double y1 = view.screenY(from.yMeters());
        double x2 = view.screenX(to.xMeters());
        double y2 = view.screenY(to.yMeters());
        g.ink(Ink.CARD, 0.8);
        g.pen(5);
        g.line(x1, y1, x2, y2);
        g.ink(Ink.ACCENT);
        g.pen(1.8);
        g.line(x1, y1, x2, y2);
        g.moved(x1, y1, -radians(), () -> ticks(g, view));
        label(g, view, x2, y2);
    }

    /** Draws a tick across both ends, and a short one every metre if a metre is at least 12 units long. */
    private void ticks(Canvas g, Viewport view) {
        double step = view.pixelsPerMeter() >= g.px(12) ? 1 : Math.max(1, meters());
        for (double at = 0; at < meters(); at += step) {
            tick(g, at * view.pixelsPerMeter(), at == 0 ? 8 : 4);
        }
        tick(g, meters() * view.pixelsPerMeter(), 8);
    }

    private static void tick(Canvas g, double x, double units) {
        g.line(x, -g.px(units), x, g.px(units));
    }

    private void label(Canvas g, Viewport view, double x, double y) {
        double width = Math.max(g.width(text(), Face.MONO_STRONG), g.width(parts(), Face.MONO_SMALL)) + g.px(16);
        double height = g.px(40);
        double edge = g.px(4);
        double left = Math.max(edge, Math.min(view.width() - width - edge, x + g.px(14)));
        double top = Math.max(edge, Math.min(view.height() - height - edge, y + g.px(10)));
        Outline ground = WorldPainter.textGround(g, Ink.CARD, 1, left, top, width, height);
        g.ink(Ink.ACCENT);
        g.pen(1);
        g.draw(ground);
        g.ink(Ink.TEXT);
        g.text(text(), Face.MONO_STRONG, left + width / 2, top + g.px(13));
        g.ink(Ink.QUIET);
        g.text(parts(), Face.MONO_SMALL, left + width / 2, top + g.px(29));
    }
}
