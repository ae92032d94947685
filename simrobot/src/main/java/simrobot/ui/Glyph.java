package simrobot.ui;

import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import javax.swing.Icon;
import simgsm.ui.CodeIcon;
import simgsm.ui.Theme;

/** The pictograms that only this window needs. */
public enum Glyph {
    BRAKE,
    GRID,
    POINTER,
    WALL,
    BOX,
    HOME,
    TREADMILL,
    UNDO,
    REDO,
    RULER,
    RECORD,
    EDIT;

    public Icon icon() {
        return new CodeIcon(CodeIcon.SIDE) {
            @Override
            protected void draw(Graphics2D g) {
                Glyph.this.draw(g);
            }
        };
    }

    private void draw(Graphics2D g) {
        g.setStroke(Theme.stroke(1.4 / Theme.zoom()));
        switch (this) {
            case BRAKE -> g.fill(new Rectangle2D.Double(3.5, 3.5, 9, 9));
            case GRID -> {
                for (double at : new double[] {3, 8, 13}) {
                    lines(g, at, 2, at, 14, 2, at, 14, at);
                }
            }
            case POINTER -> path(g, true, 4, 2, 4, 13, 7, 10.2, 9.2, 14.4, 11, 13.4, 8.9, 9.5, 12.6, 9.2);
            case WALL -> {
                lines(g, 2.5, 12.5, 13.5, 3.5);
                g.fill(new Ellipse2D.Double(1, 11, 3.4, 3.4));
                g.fill(new Ellipse2D.Double(11.6, 1.6, 3.4, 3.4));
            }
            case BOX -> {
                g.draw(new Rectangle2D.Double(2.5, 4, 11, 8));
                lines(g, 5, 9.5, 8, 6.5, 8, 9.5, 11, 6.5);
            }
            case HOME -> {
                g.draw(new Ellipse2D.Double(3, 5, 8, 8));
                lines(g, 9.8, 6.2, 14, 2, 14, 2, 10.8, 2.3, 14, 2, 13.7, 5.2);
            }
            case TREADMILL -> {
                g.draw(new Rectangle2D.Double(1.5, 4, 13, 8));
                path(g, false, 4.5, 6, 6.5, 8, 4.5, 10);
                path(g, false, 9, 6, 11, 8, 9, 10);
            }
            case UNDO -> undo(g);
            case REDO -> {
                g.translate(CodeIcon.SIDE, 0);
                g.scale(-1, 1);
                undo(g);
            }
            case RULER -> {
                path(g, false, 1.8, 11, 11, 1.8, 14.2, 5, 5, 14.2, 1.8, 11);
                lines(g, 4.6, 8.2, 6, 9.6, 6.9, 5.9, 8.9, 7.9, 9.2, 3.6, 10.6, 5);
            }
            case RECORD -> g.fill(new Ellipse2D.Double(3.5, 3.5, 9, 9));
            case EDIT -> {
                path(g, false, 2.5, 13.5, 3.3, 10.3, 10.8, 2.8, 13.2, 5.2, 5.7, 12.7, 2.5, 13.5);
                lines(g, 9.2, 4.4, 11.6, 6.8);
            }
        }
    }

    private static void undo(Graphics2D g) {
        path(g, false, 5.5, 2.5, 2.5, 5.5, 5.5, 8.5);
        Path2D bow = new Path2D.Double();
        bow.moveTo(2.8, 5.5);
        bow.lineTo(9.5, 5.5);
        bow.curveTo(14.8, 5.5, 14.8, 13, 9.5, 13);
        bow.lineTo(6, 13);
        g.draw(bow);
    }

    private static void lines(Graphics2D g, double... xy) {
        for (int i = 0; i + 3 < xy.length; i += 4) {
            g.draw(new Line2D.Double(xy[i], xy[i + 1], xy[i + 2], xy[i + 3]));
        }
    }

    private static void path(Graphics2D g, boolean filled, double... xy) {
        Path2D path = new Path2D.Double();
        path.moveTo(xy[0], xy[1]);
        for (int i = 2; i < xy.length; i += 2) {
            path.lineTo(xy[i], xy[i + 1]);
        }
        if (filled) {
            path.closePath();
            g.fill(path);
        } else {
            g.draw(path);
        }
    }
}
