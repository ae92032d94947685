package simgsm.ui;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.util.function.Consumer;
import simgsm.draw.Appearance;
import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.draw.Outline;

/** A canvas on a screen or an image. Reads only its own fields, so it works on every thread. */
public final class GraphicsCanvas implements Canvas {
    private final Appearance appearance;
    private final double zoom;
    private Graphics2D g;

    /** Draws with the window's current appearance and zoom; on the event thread. */
    public GraphicsCanvas(Graphics2D g) {
        this(g, Theme.appearance(), Theme.zoom());
    }

    public GraphicsCanvas(Graphics2D g, Appearance appearance, double zoom) {
        this.g = g;
        this.appearance = appearance;
        this.zoom = zoom;
        Drawing.prepare(g);
    }

    static Path2D path(Outline outline) {
        Path2D path = new Path2D.Double();
        CharSequence steps = outline.steps();
        int at = 0;
        for (int i = 0; i < steps.length(); i++) {
            switch (steps.charAt(i)) {
                case 'M' -> path.moveTo(outline.coordinate(at), outline.coordinate(at + 1));
                case 'L' -> path.lineTo(outline.coordinate(at), outline.coordinate(at + 1));
                case 'C' -> {
                    path.curveTo(
                            outline.coordinate(at),
                            outline.coordinate(at + 1),
                            outline.coordinate(at + 2),
                            outline.coordinate(at + 3),
                            outline.coordinate(at + 4),
                            outline.coordinate(at + 5));
                    at += 4;
                }
                default -> {
                    path.closePath();
                    at -= 2;
                }
            }
            at += 2;
        }
        return path;
    }

    @Override
    public double px(double units) {
        return units * zoom;
    }

    @Override
    public void ink(Ink ink, double opacity) {
        g.setColor(Theme.color(ink, appearance, opacity));
    }

    @Override
    public void pen(double width, double dash) {
        g.setStroke(Theme.stroke(width * zoom, dash * zoom));
    }

    @Override
    public void draw(Outline outline) {
        g.draw(path(outline));
    }

    @Override
    public void fill(Outline outline) {
        g.fill(path(outline));
    }

    @Override
    public void bar(double x, double y, double width, double height) {
        Drawing.fillCrisp(g, x, y, width, height);
    }

    @Override
    public void text(String text, Face face, double x, double y) {
        Drawing.centred(g, text, font(face), x, y);
    }

    @Override
    public double width(String text, Face face) {
        return Drawing.width(font(face), text);
    }

    private Font font(Face face) {
        return Theme.font(face.isMonospaced(), face.isBold(), face.points() * zoom);
    }

    @Override
    public void moved(double x, double y, double radians, Runnable inside) {
        onCopy(
                copy -> {
                    copy.translate(x, y);
                    copy.rotate(radians);
                },
                inside);
    }

    @Override
    public void clipped(Outline edge, Runnable inside) {
        onCopy(copy -> copy.clip(path(edge)), inside);
    }

    @Override
    public void group(String name, Runnable inside) {
        onCopy(copy -> {}, inside);
    }

    private void onCopy(Consumer<Graphics2D> change, Runnable inside) {
        Graphics2D before = g;
        g = (Graphics2D) before.create();
        try {
            change.accept(g);
            inside.run();
        } finally {
            g.dispose();
            g = before;
        }
    }
}
