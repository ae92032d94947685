package simrobot.ui.floor;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.PathIterator;
import java.util.Locale;

/** Shapes, colours and strokes as SVG writes them. */
final class SvgText {
    private SvgText() {}

    /** With at most two decimals, which is a hundredth of a pixel. */
    static String number(double value) {
        String text = String.format(Locale.ROOT, "%.2f", value);
        text = text.replaceFirst("0+$", "").replaceFirst("\\.$", "");
        return text.equals("-0") ? "0" : text;
    }

    static String path(Shape shape, AffineTransform transform) {
        StringBuilder path = new StringBuilder();
        double[] c = new double[6];
        for (PathIterator i = shape.getPathIterator(transform); !i.isDone(); i.next()) {
            int kind = i.currentSegment(c);
            path.append("MLQCZ".charAt(kind));
            int numbers = kind == PathIterator.SEG_CLOSE ? 0 : 2 * Math.max(1, kind);
            for (int k = 0; k < numbers; k++) {
                path.append(k == 0 ? "" : " ").append(number(c[k]));
            }
        }
        return path.toString();
    }

    static String fill(Color color) {
        return " fill=\"" + hex(color) + "\"" + opacity("fill-opacity", color);
    }

    static String stroke(Color color, BasicStroke stroke, double scale) {
        StringBuilder text = new StringBuilder(" fill=\"none\" stroke=\"" + hex(color) + "\"");
        text.append(opacity("stroke-opacity", color));
        text.append(" stroke-width=\"")
                .append(number(stroke.getLineWidth() * scale))
                .append('"');
        if (stroke.getEndCap() == BasicStroke.CAP_ROUND) {
            text.append(" stroke-linecap=\"round\"");
        }
        if (stroke.getLineJoin() == BasicStroke.JOIN_ROUND) {
            text.append(" stroke-linejoin=\"round\"");
        }
        if (stroke.getDashArray() != null) {
            StringBuilder dashes = new StringBuilder();
            for (float dash : stroke.getDashArray()) {
                dashes.append(dashes.length() == 0 ? "" : " ").append(number(dash * scale));
            }
            text.append(" stroke-dasharray=\"").append(dashes).append('"');
        }
        return text.toString();
    }

    static String font(Font font) {
        boolean mono = font.getFamily(Locale.ROOT).toLowerCase(Locale.ROOT).contains("mono");
        return " font-family=\"" + (mono ? "monospace" : "sans-serif") + "\" font-size=\"" + number(font.getSize2D())
                + "\"" + (font.isBold() ? " font-weight=\"bold\"" : "");
    }

    static String escaped(String text) {
        StringBuilder escaped = new StringBuilder();
        text.codePoints().forEach(c -> {
            switch (c) {
                case '<' -> escaped.append("&lt;");
                case '&' -> escaped.append("&amp;");
                case '>' -> escaped.append("&gt;");
                case '"' -> escaped.append("&quot;");
                default -> escaped.appendCodePoint(c < 0x20 || c == 0xFFFE || c == 0xFFFF ? ' ' : c);
            }
        });
        return escaped.toString();
    }

    private static String hex(Color color) {
        return String.format(Locale.ROOT, "#%06x", color.getRGB() & 0xFFFFFF);
    }

    private static String opacity(String name, Color color) {
        return color.getAlpha() == 255 ? "" : " " + name + "=\"" + number(color.getAlpha() / 255.0) + "\"";
    }
}
