package simgsm.ui;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import simgsm.ui.Theme.Ink;

/** The shape of a lamp. Each state has a shape of its own, so that nothing hangs on its colour. */
public enum Mark {
    /** Steady: stopped, idle. */
    SQUARE(true),
    /** Going: moving, sending. */
    ARROW(true),
    /** Collision, failure. */
    BURST(true),
    /** Present but empty: no motors, off. */
    RING(false),
    /** Cut off: disconnected. */
    SLASHED_RING(false),
    /** In order: linked, attached. */
    DISC(true),
    /** Under way: searching, alerting. */
    HALF_DISC(true),
    /** A ringing or waiting thing. */
    DIAMOND(true),
    /** Done. */
    TICK(false),
    /** Refused. */
    CROSS(false);

    private final boolean filled;

    Mark(boolean filled) {
        this.filled = filled;
    }

    /** Paints the mark in a circle of that radius in pixels. */
    public void paint(Graphics2D g, double x, double y, double radius, Ink ink) {
        g.setColor(ink.color());
        g.setStroke(Theme.stroke(Math.max(1.4, radius / Theme.zoom() * 0.34)));
        Shape outline = outline(x, y, radius);
        if (filled) {
            g.fill(outline);
        } else {
            g.draw(outline);
        }
        if (this == HALF_DISC) {
            g.setStroke(Theme.stroke(1.4));
            g.draw(circle(x, y, radius * 0.86));
        }
    }

    private Shape outline(double x, double y, double r) {
        return switch (this) {
            case SQUARE -> new Rectangle2D.Double(x - 0.82 * r, y - 0.82 * r, 1.64 * r, 1.64 * r);
            case ARROW -> path(x, y, r, -0.75, -0.95, 1, 0, -0.75, 0.95, -0.35, 0);
            case BURST -> burst(x, y, r);
            case RING -> circle(x, y, r * 0.8);
            case SLASHED_RING -> slashedRing(x, y, r * 0.8);
            case DISC -> circle(x, y, r * 0.92);
            case HALF_DISC -> new Arc2D.Double(x - r * 0.86, y - r * 0.86, 1.72 * r, 1.72 * r, -90, 180, Arc2D.PIE);
            case DIAMOND -> path(x, y, r, 0, -1, 1, 0, 0, 1, -1, 0);
            case TICK -> open(x, y, r, -0.8, 0.1, -0.25, 0.65, 0.85, -0.6);
            case CROSS -> cross(x, y, r * 0.65);
        };
    }

    private static Shape circle(double x, double y, double r) {
        return new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r);
    }

    private static Shape slashedRing(double x, double y, double r) {
        var path = new Path2D.Double(circle(x, y, r));
        path.moveTo(x - r * 1.1, y + r * 1.1);
        path.lineTo(x + r * 1.1, y - r * 1.1);
        return path;
    }

    private static Shape cross(double x, double y, double r) {
        var path = new Path2D.Double();
        path.moveTo(x - r, y - r);
        path.lineTo(x + r, y + r);
        path.moveTo(x + r, y - r);
        path.lineTo(x - r, y + r);
        return path;
    }

    private static Shape burst(double x, double y, double r) {
        int points = 8;
        var path = new Path2D.Double();
        for (int i = 0; i < 2 * points; i++) {
            double reach = i % 2 == 0 ? r * 1.1 : r * 0.55;
            double angle = Math.PI * i / points - Math.PI / 2;
            double px = x + reach * Math.cos(angle);
            double py = y + reach * Math.sin(angle);
            if (i == 0) {
                path.moveTo(px, py);
            } else {
                path.lineTo(px, py);
            }
        }
        path.closePath();
        return new Area(path);
    }

    private static Path2D open(double x, double y, double r, double... points) {
        var path = new Path2D.Double();
        path.moveTo(x + r * points[0], y + r * points[1]);
        for (int i = 2; i < points.length; i += 2) {
            path.lineTo(x + r * points[i], y + r * points[i + 1]);
        }
        return path;
    }

    private static Path2D path(double x, double y, double r, double... points) {
        Path2D path = open(x, y, r, points);
        path.closePath();
        return path;
    }
}
