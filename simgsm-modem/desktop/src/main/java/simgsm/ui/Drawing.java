package simgsm.ui;

import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.ArrayList;
import java.util.List;
import simgsm.draw.Ink;

/** Rendering hints, pixel-aligned rectangles and texts for painters. */
public final class Drawing {
    private Drawing() {}

    private static final FontRenderContext FRACTIONAL = new FontRenderContext(null, true, true);

    /** A copy with the rendering hints set; the caller disposes of it. */
    public static Graphics2D on(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        prepare(g);
        return g;
    }

    /**
     * Sets the rendering hints: antialiasing, exact geometry, and grey-level text, which looks the same on every
     * screen.
     */
    public static void prepare(Graphics2D g) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
        g.setRenderingHint(RenderingHints.KEY_RENDERING, RenderingHints.VALUE_RENDER_QUALITY);
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    }

    /** The nearest x on the edge of a device pixel, at any scale of the display. */
    public static double snapX(Graphics2D g, double x) {
        AffineTransform t = g.getTransform();
        return isUpright(t)
                ? (Math.rint(x * t.getScaleX() + t.getTranslateX()) - t.getTranslateX()) / t.getScaleX()
                : x;
    }

    /** The nearest y on the edge of a device pixel. */
    public static double snapY(Graphics2D g, double y) {
        AffineTransform t = g.getTransform();
        return isUpright(t)
                ? (Math.rint(y * t.getScaleY() + t.getTranslateY()) - t.getTranslateY()) / t.getScaleY()
                : y;
    }

    private static boolean isUpright(AffineTransform t) {
        return t.getShearX() == 0 && t.getShearY() == 0 && t.getScaleX() != 0 && t.getScaleY() != 0;
    }

    /** Fills a rectangle with its edges on device pixels, so that bars and grid lines are sharp at a scale of 125 %. */
    public static void fillCrisp(Graphics2D g, double x, double y, double width, double height) {
        double left = snapX(g, x);
        double top = snapY(g, y);
        double right = Math.max(
                snapX(g, x + width), left + (width > 0 ? 1 / g.getTransform().getScaleX() : 0));
        double bottom = Math.max(
                snapY(g, y + height), top + (height > 0 ? 1 / g.getTransform().getScaleY() : 0));
        g.fill(new Rectangle2D.Double(left, top, right - left, bottom - top));
    }

    /** A rule of one logical pixel (at least one device pixel) along the x axis. */
    public static void horizontal(Graphics2D g, double x1, double x2, double y) {
        fillCrisp(g, x1, y, x2 - x1, Theme.exact(1));
    }

    /** A rule of one logical pixel (at least one device pixel) along the y axis. */
    public static void vertical(Graphics2D g, double x, double y1, double y2) {
        fillCrisp(g, x, y1, Theme.exact(1), y2 - y1);
    }

    /** A rounded box. @param radius corner radius in pixels */
    public static RoundRectangle2D round(double x, double y, double width, double height, double radius) {
        return new RoundRectangle2D.Double(x, y, width, height, 2 * radius, 2 * radius);
    }

    public static void line(Graphics2D g, double x1, double y1, double x2, double y2) {
        g.draw(new Line2D.Double(x1, y1, x2, y2));
    }

    /** Text centred on a point, vertically by the height of its capitals. */
    public static void centred(Graphics2D g, String text, Font font, double x, double y) {
        g.setFont(font);
        double width = font.getStringBounds(text, FRACTIONAL).getWidth();
        g.drawString(text, (float) (x - width / 2), (float) (y + capHeight(g, font) / 2));
    }

    /** Text that ends at x, on the baseline y. */
    public static void rightAligned(Graphics2D g, String text, double x, double y) {
        double width = g.getFontMetrics().getStringBounds(text, g).getWidth();
        g.drawString(text, (float) (x - width), (float) y);
    }

    /** The width of a text with these rendering hints, in pixels, rounded up. */
    public static int width(Font font, String text) {
        return (int) Math.ceil(font.getStringBounds(text, FRACTIONAL).getWidth());
    }

    /** The height of a capital letter, in pixels. */
    public static double capHeight(Graphics2D g, Font font) {
        return font.createGlyphVector(g.getFontRenderContext(), "H")
                .getVisualBounds()
                .getHeight();
    }

    /** The text, cut with an ellipsis to fit a width in pixels. */
    public static String fitted(Font font, String text, double width) {
        if (width(font, text) <= width) {
            return text;
        }
        int end = text.length();
        while (end > 0 && width(font, text.substring(0, end) + "\u2026") > width) {
            end--;
        }
        return end == 0 ? "" : text.substring(0, end) + "\u2026";
    }

    /** The text in rows of whole words, at most the given number; the last is cut with an ellipsis to fit. */
    public static List<String> wrapped(Font font, String text, double width, int mostRows) {
        List<String> rows = new ArrayList<>();
        String rest = text.strip();
        while (!rest.isEmpty()) {
            int end = rows.size() + 1 < mostRows ? firstRow(font, rest, width) : rest.length();
            rows.add(fitted(font, rest.substring(0, end), width));
            rest = rest.substring(end).strip();
        }
        return rows;
    }

    /** The length of the first row: all, or the whole words that fit, at least one. */
    static int firstRow(Font font, String text, double width) {
        int end = text.length();
        while (width(font, text.substring(0, end)) > width) {
            int blank = text.lastIndexOf(' ', end - 1);
            if (blank <= 0) {
                return end;
            }
            end = blank;
        }
        return end;
    }

    /** The text, cut in front with an ellipsis if it does not fit: numbers differ in their last digits. */
    public static String fittedEnd(Font font, String text, double width) {
        if (width(font, text) <= width) {
            return text;
        }
        int start = 1;
        while (start < text.length() && width(font, "\u2026" + text.substring(start)) > width) {
            start++;
        }
        return start == text.length() ? "" : "\u2026" + text.substring(start);
    }

    /** Three dots along the longer side: the grip of a divider. */
    public static void grip(Graphics2D g, double w, double h) {
        double d = Theme.exact(2.5);
        g.setColor(Theme.color(Ink.CONTROL_LINE));
        for (int k = -1; k <= 1; k++) {
            double x = w / 2 + (w > h ? k * 3 * d : 0);
            double y = h / 2 + (w > h ? 0 : k * 3 * d);
            g.fill(new Ellipse2D.Double(x - d / 2, y - d / 2, d, d));
        }
    }
}
