package simgsm.draw;

import java.util.function.Function;

/** A canvas that writes an SVG document or a part of one; one design unit is one pixel. */
public final class SvgCanvas implements Canvas {
    /** Mean width of a letter of the usual sans-serif and monospaced faces, as a share of the size. */
    private static final double SANS_WIDTH = 0.58;

    private static final double MONO_WIDTH = 0.602;
    /** Half the height of a capital letter, as a share of the size. */
    private static final double HALF_CAPITAL = 0.365;

    private final Function<Ink, String> colors;
    private final StringBuilder body = new StringBuilder();
    private int clips;
    private Ink ink = Ink.TEXT;
    private double opacity = 1;
    private double penWidth = 1;
    private double dash;

    /**
     * @param colors the document's colour of an ink: {@code #rrggbb}, or the name of a variable of its style sheet
     */
    public SvgCanvas(Function<Ink, String> colors) {
        this.colors = colors;
    }

    /** The drawn elements. */
    public String elements() {
        return body.toString();
    }

    /** A document of the drawn elements, with the given size in pixels. */
    public String document(double width, double height, String title) {
        String size = number(width) + "\" height=\"" + number(height);
        return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size
                + "\" viewBox=\"0 0 " + number(width) + " " + number(height) + "\">\n<title>" + escaped(title)
                + "</title>\n" + body + "</svg>\n";
    }

    @Override
    public double px(double units) {
        return units;
    }

    @Override
    public void ink(Ink newInk, double newOpacity) {
        ink = newInk;
        opacity = newOpacity;
    }

    @Override
    public void pen(double newWidth, double newDash) {
        penWidth = newWidth;
        dash = newDash;
    }

    @Override
    public void draw(Outline outline) {
        String ends = dash == 0 ? " stroke-linecap=\"round\"" : " stroke-dasharray=\"" + number(dash) + "\"";
        path(
                outline,
                " fill=\"none\"" + color("stroke") + " stroke-width=\"" + number(penWidth) + "\"" + ends
                        + " stroke-linejoin=\"round\"");
    }

    @Override
    public void fill(Outline outline) {
        path(outline, color("fill"));
    }

    private void path(Outline outline, String style) {
        if (!outline.isEmpty()) {
            body.append("<path d=\"").append(outline).append('"').append(style).append("/>\n");
        }
    }

    @Override
    public void bar(double x, double y, double width, double height) {
        double left = Math.rint(x);
        double top = Math.rint(y);
        double right = Math.max(left + 1, Math.rint(x + width));
        double low = Math.max(top + 1, Math.rint(y + height));
        fill(Outline.box(left, top, right - left, low - top));
    }

    @Override
    public void text(String text, Face face, double x, double y) {
        body.append("<text x=\"")
                .append(number(x))
                .append("\" y=\"")
                .append(number(y + HALF_CAPITAL * face.points()))
                .append("\" text-anchor=\"middle\" font-family=\"")
                .append(face.isMonospaced() ? "monospace" : "sans-serif")
                .append("\" font-size=\"")
                .append(number(face.points()))
                .append(face.isBold() ? "\" font-weight=\"bold\"" : "\"")
                .append(color("fill"))
                .append('>')
                .append(escaped(text))
                .append("</text>\n");
    }

    @Override
    public double width(String text, Face face) {
        return text.length() * face.points() * (face.isMonospaced() ? MONO_WIDTH : SANS_WIDTH);
    }

    @Override
    public void moved(double x, double y, double radians, Runnable inside) {
        element(
                "<g transform=\"translate(" + number(x) + "," + number(y) + ") rotate("
                        + number(Math.toDegrees(radians)) + ")\">",
                inside);
    }

    @Override
    public void clipped(Outline edge, Runnable inside) {
        String name = "clip" + ++clips;
        body.append("<clipPath id=\"" + name + "\"><path d=\"" + edge + "\"/></clipPath>\n");
        element("<g clip-path=\"url(#" + name + ")\">", inside);
    }

    @Override
    public void group(String name, Runnable inside) {
        element("<g class=\"" + escaped(name) + "\">", inside);
    }

    private void element(String begin, Runnable inside) {
        Ink inkBefore = ink;
        double opacityBefore = opacity;
        double widthBefore = penWidth;
        double dashBefore = dash;
        body.append(begin).append('\n');
        inside.run();
        body.append("</g>\n");
        ink(inkBefore, opacityBefore);
        pen(widthBefore, dashBefore);
    }

    private String color(String attribute) {
        String solid = " " + attribute + "=\"" + colors.apply(ink) + "\"";
        return opacity == 1 ? solid : solid + " " + attribute + "-opacity=\"" + number(opacity) + "\"";
    }

    /** At most two decimals, never an exponent and never -0. */
    public static String number(double value) {
        double rounded = Math.rint(value * 100) / 100 + 0.0;
        return rounded == (long) rounded ? Long.toString((long) rounded) : Double.toString(rounded);
    }

    /** A text escaped for XML and HTML elements and quoted attributes. */
    public static String escaped(String text) {
        StringBuilder escaped = new StringBuilder();
        text.codePoints().forEach(c -> {
            switch (c) {
                case '<' -> escaped.append("&lt;");
                case '&' -> escaped.append("&amp;");
                case '>' -> escaped.append("&gt;");
                case '"' -> escaped.append("&quot;");
                case '\'' -> escaped.append("&#39;");
                default -> escaped.appendCodePoint(c < 0x20 || c == 0xFFFE || c == 0xFFFF ? ' ' : c);
            }
        });
        return escaped.toString();
    }
}
