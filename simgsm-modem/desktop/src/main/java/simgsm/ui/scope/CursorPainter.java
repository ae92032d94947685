package simgsm.ui.scope;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.Locale;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.scope.ScopeCursors;
import simgsm.scope.ScopeCursors.CursorPlace;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;

/** Paints the cursors A and B over a picture, and the difference between them. */
final class CursorPainter {
    private static final double FLAG_UNITS = 13;

    private CursorPainter() {}

    /** @param spanMillis the width of the area */
    static void paint(Graphics2D g, ScopeCursors cursors, Rectangle2D area, double spanMillis) {
        for (int i = 0; i < 2; i++) {
            CursorPlace place = cursors.place(i);
            double x = area.getX() + area.getWidth() * place.millis() / spanMillis;
            g.setColor(Theme.color(Ink.DANGER));
            g.setStroke(Theme.dashed(1.3, 3));
            Drawing.line(g, x, area.getY(), x, area.getMaxY());
            if (cursors.hasFrequencies()) {
                double y = SpectrogramPainter.y(area, place.hertz());
                Drawing.line(g, area.getX(), y, area.getMaxX(), y);
            }
            double side = Theme.exact(FLAG_UNITS);
            double left = Math.min(x, area.getMaxX() - side);
            g.fill(Drawing.round(left, area.getY(), side, side, Theme.exact(3)));
            g.setColor(Theme.color(Ink.ON_SIGNAL));
            Drawing.centred(g, i == 0 ? "A" : "B", Theme.sans(9.5, true), left + side / 2, area.getY() + side / 2);
        }
    }

    /** As {@code A 8.0 ms  B 16.0 ms  difference 8.0 ms = 125 Hz}. */
    static String words(TextBundle texts, ScopeCursors cursors) {
        if (cursors.hasFrequencies()) {
            return texts.of(
                    "scope.cursors.both",
                    number("%.0f", cursors.place(0).hertz()),
                    number("%.0f", cursors.place(1).hertz()),
                    number("%+.0f", cursors.differenceMillis()),
                    number("%+.0f", cursors.differenceHertz()));
        }
        return texts.of(
                "scope.cursors.time",
                number("%.2f", cursors.place(0).millis()),
                number("%.2f", cursors.place(1).millis()),
                number("%+.2f", cursors.differenceMillis()),
                Double.isInfinite(cursors.periodHertz()) ? "\u221e" : number("%.0f", cursors.periodHertz()));
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value).replace('-', '\u2212');
    }
}
