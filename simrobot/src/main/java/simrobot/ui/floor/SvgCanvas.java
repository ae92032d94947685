package simrobot.ui.floor;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Composite;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.GraphicsConfiguration;
import java.awt.Paint;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.font.GlyphVector;
import java.awt.geom.AffineTransform;
import java.awt.geom.Area;
import java.awt.image.BufferedImage;
import java.util.Map;

/**
 * What is painted on it becomes an SVG document, so that the window's painters serve here, too. It takes shapes, texts, clips
 * and transforms; pictures, of which those painters paint none, it refuses.
 */
final class SvgCanvas extends ShapeCanvas {
    private static final FontRenderContext FRACTIONAL = new FontRenderContext(null, true, true);
    private static final Graphics METRICS = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).getGraphics();

    /** What all copies of a canvas write together. */
    private static final class Document {
        final StringBuilder body = new StringBuilder();
        final StringBuilder clips = new StringBuilder();
        int clipCount;
    }

    private final Document document;
    private final double width;
    private final double height;
    private final String title;
    private final RenderingHints hints = new RenderingHints(null);
    private Color color = Color.BLACK;
    private Color background = Color.WHITE;
    private BasicStroke stroke = new BasicStroke();
    private Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    private Composite composite = AlphaComposite.SrcOver;
    /** In the document's units; null for none. */
    private Area clip;

    private String clipName = "";

    SvgCanvas(double width, double height, String title) {
        this(new Document(), width, height, title);
    }

    private SvgCanvas(Document document, double width, double height, String title) {
        this.document = document;
        this.width = width;
        this.height = height;
        this.title = title;
    }

    /** The whole of it. */
    String document() {
        String size = SvgText.number(width) + "\" height=\"" + SvgText.number(height);
        return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size
                + "\" viewBox=\"0 0 " + SvgText.number(width) + " " + SvgText.number(height) + "\">\n<title>"
                + SvgText.escaped(title) + "</title>\n"
                + (document.clips.length() == 0 ? "" : "<defs>\n" + document.clips + "</defs>\n") + document.body
                + "</svg>\n";
    }

    // ---- what is written -------------------------------------------------------------------------------------------

    private void element(String name, String attributes) {
        document.body
                .append('<')
                .append(name)
                .append(attributes)
                .append(clipName)
                .append("/>\n");
    }

    @Override
    public void draw(Shape shape) {
        double scale = Math.sqrt(Math.abs(present().getDeterminant()));
        element("path", " d=\"" + SvgText.path(shape, present()) + "\"" + SvgText.stroke(color, stroke, scale));
    }

    @Override
    public void fill(Shape shape) {
        if (color.getAlpha() > 0) {
            element("path", " d=\"" + SvgText.path(shape, present()) + "\"" + SvgText.fill(color));
        }
    }

    @Override
    public void drawString(String text, float x, float y) {
        double[] m = new double[6];
        AffineTransform at = new AffineTransform(present());
        at.translate(x, y);
        at.getMatrix(m);
        boolean upright = m[0] == 1 && m[1] == 0 && m[2] == 0 && m[3] == 1;
        String place = upright
                ? " x=\"" + SvgText.number(m[4]) + "\" y=\"" + SvgText.number(m[5]) + "\""
                : " transform=\"matrix(" + m[0] + " " + m[1] + " " + m[2] + " " + m[3] + " " + SvgText.number(m[4])
                        + " " + SvgText.number(m[5]) + ")\"";
        document.body
                .append("<text")
                .append(place)
                .append(SvgText.font(font))
                .append(SvgText.fill(color))
                .append(clipName)
                .append('>')
                .append(SvgText.escaped(text))
                .append("</text>\n");
    }

    @Override
    public void drawString(String text, int x, int y) {
        drawString(text, (float) x, (float) y);
    }

    @Override
    public void drawGlyphVector(GlyphVector glyphs, float x, float y) {
        fill(glyphs.getOutline(x, y));
    }

    // ---- clips -----------------------------------------------------------------------------------------------------

    @Override
    public void clip(Shape shape) {
        Area more = new Area(present().createTransformedShape(shape));
        if (clip != null) {
            more.intersect(clip);
        }
        take(more);
    }

    @Override
    public void setClip(Shape shape) {
        take(shape == null ? null : new Area(present().createTransformedShape(shape)));
    }

    private void take(Area newClip) {
        clip = newClip;
        clipName = "";
        if (clip != null) {
            String name = "clip" + ++document.clipCount;
            document.clips
                    .append("<clipPath id=\"")
                    .append(name)
                    .append("\"><path d=\"")
                    .append(SvgText.path(clip, null))
                    .append("\"/></clipPath>\n");
            clipName = " clip-path=\"url(#" + name + ")\"";
        }
    }

    @Override
    public Shape getClip() {
        try {
            return clip == null ? null : present().createInverse().createTransformedShape(clip);
        } catch (java.awt.geom.NoninvertibleTransformException flat) {
            return new Rectangle();
        }
    }

    @Override
    public void clipRect(int x, int y, int w, int h) {
        clip(new Rectangle(x, y, w, h));
    }

    @Override
    public void setClip(int x, int y, int w, int h) {
        setClip(new Rectangle(x, y, w, h));
    }

    @Override
    public Rectangle getClipBounds() {
        Shape shape = getClip();
        return shape == null ? null : shape.getBounds();
    }

    // ---- state -----------------------------------------------------------------------------------------------------

    @Override
    public Graphics create() {
        SvgCanvas copy = new SvgCanvas(document, width, height, title);
        copy.setTransform(present());
        copy.hints.putAll(hints);
        copy.color = color;
        copy.background = background;
        copy.stroke = stroke;
        copy.font = font;
        copy.composite = composite;
        copy.clip = clip;
        copy.clipName = clipName;
        return copy;
    }

    @Override
    public void dispose() {
        // nothing is held
    }

    @Override
    public Color getColor() {
        return color;
    }

    @Override
    public void setColor(Color newColor) {
        color = newColor == null ? color : newColor;
    }

    @Override
    public void setPaint(Paint paint) {
        if (paint instanceof Color plain) {
            color = plain;
        }
    }

    @Override
    public Paint getPaint() {
        return color;
    }

    @Override
    public void setStroke(Stroke newStroke) {
        stroke = (BasicStroke) newStroke;
    }

    @Override
    public Stroke getStroke() {
        return stroke;
    }

    @Override
    public Font getFont() {
        return font;
    }

    @Override
    public void setFont(Font newFont) {
        font = newFont == null ? font : newFont;
    }

    @Override
    public FontMetrics getFontMetrics(Font which) {
        return METRICS.getFontMetrics(which);
    }

    @Override
    public FontRenderContext getFontRenderContext() {
        return FRACTIONAL;
    }

    @Override
    public void setComposite(Composite newComposite) {
        composite = newComposite;
    }

    @Override
    public Composite getComposite() {
        return composite;
    }

    @Override
    public void setBackground(Color newBackground) {
        background = newBackground;
    }

    @Override
    public Color getBackground() {
        return background;
    }

    @Override
    public void setRenderingHint(RenderingHints.Key key, Object value) {
        hints.put(key, value);
    }

    @Override
    public Object getRenderingHint(RenderingHints.Key key) {
        return hints.get(key);
    }

    @Override
    public void setRenderingHints(Map<?, ?> newHints) {
        hints.clear();
        hints.putAll(newHints);
    }

    @Override
    public void addRenderingHints(Map<?, ?> more) {
        hints.putAll(more);
    }

    @Override
    public RenderingHints getRenderingHints() {
        return (RenderingHints) hints.clone();
    }

    @Override
    public GraphicsConfiguration getDeviceConfiguration() {
        return null;
    }

    @Override
    public boolean hit(Rectangle rectangle, Shape shape, boolean onStroke) {
        return present().createTransformedShape(shape).intersects(rectangle);
    }

    @Override
    public void setPaintMode() {
        // there is no other
    }

    @Override
    public void setXORMode(Color other) {
        throw new UnsupportedOperationException("SVG has no XOR");
    }
}
