package simgsm.ui;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Arc2D;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import javax.swing.Icon;

/** The suite's pictograms, drawn by code on a square of 16. */
public enum Symbol {
    CALL,
    HANG_UP,
    ENVELOPE,
    ENVELOPE_OPEN,
    MENU,
    UP,
    DOWN,
    LEFT,
    RIGHT,
    OK,
    CLOSE,
    PLUS,
    MINUS,
    PLAY,
    PAUSE,
    STEP,
    POWER,
    MOTOR,
    SUN_MOON,
    SPEAKER,
    SPEAKER_OFF,
    PHONE,
    ROBOT,
    FOLLOW,
    TRAIL,
    RAYS,
    FIT,
    LIST,
    WAVE,
    TICK,
    TICKS,
    BROADCAST,
    ERASE;

    private static final Stroke PEN = new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);

    /** As an icon of 16 units. */
    public Icon icon() {
        return icon(CodeIcon.SIDE);
    }

    /** As an icon of another size in units. */
    public Icon icon(double units) {
        return new CodeIcon(units) {
            @Override
            protected void draw(Graphics2D g) {
                Symbol.this.draw(g);
            }
        };
    }

    /** Draws centred on a point in the colour that is set. @param size side in pixels */
    public void paint(Graphics2D g, double x, double y, double size) {
        Graphics2D copy = (Graphics2D) g.create();
        try {
            copy.translate(x - size / 2, y - size / 2);
            copy.scale(size / CodeIcon.SIDE, size / CodeIcon.SIDE);
            draw(copy);
        } finally {
            copy.dispose();
        }
    }

    private void draw(Graphics2D g) {
        g.setStroke(PEN);
        switch (this) {
            case CALL -> g.fill(handset(-45));
            case HANG_UP -> g.fill(handset(90));
            case ENVELOPE -> envelope(g);
            case ENVELOPE_OPEN -> openEnvelope(g);
            case MENU -> lines(g, 3, 4.5, 13, 4.5, 3, 8, 13, 8, 3, 11.5, 13, 11.5);
            case UP -> path(g, false, 3.5, 10.5, 8, 6, 12.5, 10.5);
            case DOWN -> path(g, false, 3.5, 6, 8, 10.5, 12.5, 6);
            case LEFT -> path(g, false, 10, 3.5, 5.5, 8, 10, 12.5);
            case RIGHT -> path(g, false, 6, 3.5, 10.5, 8, 6, 12.5);
            case OK -> g.draw(new Ellipse2D.Double(4, 4, 8, 8));
            case CLOSE -> lines(g, 4, 4, 12, 12, 12, 4, 4, 12);
            case PLUS -> lines(g, 8, 3, 8, 13, 3, 8, 13, 8);
            case MINUS -> lines(g, 3, 8, 13, 8);
            case PLAY -> path(g, true, 5, 3, 13, 8, 5, 13);
            case PAUSE -> bars(g);
            case STEP -> {
                path(g, true, 3.5, 3.5, 10, 8, 3.5, 12.5);
                g.fill(new Rectangle2D.Double(11, 3.5, 2, 9));
            }
            case POWER -> {
                g.draw(new Arc2D.Double(3, 3.5, 10, 10, 125, 290, Arc2D.OPEN));
                lines(g, 8, 2, 8, 7.5);
            }
            case MOTOR -> motor(g);
            case SUN_MOON -> {
                g.draw(new Ellipse2D.Double(2.5, 2.5, 11, 11));
                g.fill(new Arc2D.Double(2.5, 2.5, 11, 11, -90, 180, Arc2D.PIE));
            }
            case SPEAKER -> {
                speaker(g);
                g.draw(new Arc2D.Double(6.5, 4.5, 5, 7, -55, 110, Arc2D.OPEN));
                g.draw(new Arc2D.Double(6, 2.5, 8.5, 11, -55, 110, Arc2D.OPEN));
            }
            case SPEAKER_OFF -> {
                speaker(g);
                lines(g, 10.5, 6, 14, 10, 14, 6, 10.5, 10);
            }
            case PHONE -> phone(g);
            case ROBOT -> robot(g);
            case FOLLOW -> {
                g.draw(new Ellipse2D.Double(4, 4, 8, 8));
                lines(g, 8, 1.5, 8, 5, 8, 11, 8, 14.5, 1.5, 8, 5, 8, 11, 8, 14.5, 8);
            }
            case TRAIL -> trail(g);
            case RAYS -> {
                g.fill(new Ellipse2D.Double(1.5, 6.3, 3.4, 3.4));
                lines(g, 6, 7, 13.5, 3, 6.5, 8, 14.5, 8, 6, 9, 13.5, 13);
            }
            case FIT -> corners(g);
            case LIST -> {
                lines(g, 6, 4.5, 13.5, 4.5, 6, 8, 13.5, 8, 6, 11.5, 13.5, 11.5);
                lines(g, 2.8, 4.5, 2.9, 4.5, 2.8, 8, 2.9, 8, 2.8, 11.5, 2.9, 11.5);
            }
            case WAVE -> wave(g);
            case TICK -> path(g, false, 3.5, 8.5, 6.5, 11.5, 12.5, 4.5);
            case TICKS -> {
                path(g, false, 1.5, 8.5, 4.5, 11.5, 10, 4.5);
                path(g, false, 7.5, 10.8, 8.2, 11.5, 14.2, 4.5);
            }
            case BROADCAST -> broadcast(g);
            case ERASE -> {
                path(g, false, 6, 3.5, 14, 3.5, 14, 12.5, 6, 12.5, 1.8, 8, 6, 3.5);
                lines(g, 7.8, 6, 11.8, 10, 11.8, 6, 7.8, 10);
            }
        }
    }

    /** A telephone receiver, turned and then centred; 0 degrees lies with its ends to the right. */
    private static Area handset(double degrees) {
        Area body = new Area(new Arc2D.Double(1.2, 1.2, 13.6, 13.6, 118, 124, Arc2D.PIE));
        body.subtract(new Area(new Ellipse2D.Double(4.9, 3.6, 8.8, 8.8)));
        body.add(new Area(new RoundRectangle2D.Double(3.7, 1.5, 4.8, 3.5, 1.6, 1.6)));
        body.add(new Area(new RoundRectangle2D.Double(3.7, 11, 4.8, 3.5, 1.6, 1.6)));
        var turn = AffineTransform.getRotateInstance(Math.toRadians(degrees), 8, 8);
        Area turned = body.createTransformedArea(turn);
        Rectangle2D box = turned.getBounds2D();
        return turned.createTransformedArea(
                AffineTransform.getTranslateInstance(8 - box.getCenterX(), 8 - box.getCenterY()));
    }

    private static void envelope(Graphics2D g) {
        g.draw(new RoundRectangle2D.Double(1.5, 3.5, 13, 9.5, 2, 2));
        path(g, false, 2, 4.5, 8, 9, 14, 4.5);
    }

    private static void openEnvelope(Graphics2D g) {
        path(g, false, 1.5, 6.5, 8, 2, 14.5, 6.5, 14.5, 13.5, 1.5, 13.5, 1.5, 6.5, 8, 10.5, 14.5, 6.5);
    }

    private static void bars(Graphics2D g) {
        g.fill(new Rectangle2D.Double(4, 3, 2.8, 10));
        g.fill(new Rectangle2D.Double(9.2, 3, 2.8, 10));
    }

    private static void motor(Graphics2D g) {
        g.draw(new Ellipse2D.Double(3, 3, 10, 10));
        g.fill(new Ellipse2D.Double(6.4, 6.4, 3.2, 3.2));
        for (int i = 0; i < 6; i++) {
            double a = Math.PI * i / 3;
            g.draw(new Line2D.Double(
                    8 + 5 * Math.cos(a), 8 + 5 * Math.sin(a), 8 + 6.6 * Math.cos(a), 8 + 6.6 * Math.sin(a)));
        }
    }

    private static void speaker(Graphics2D g) {
        path(g, true, 1.5, 6, 4, 6, 7.5, 3, 7.5, 13, 4, 10, 1.5, 10);
    }

    private static void phone(Graphics2D g) {
        g.draw(new RoundRectangle2D.Double(4, 1.5, 8, 13, 2.5, 2.5));
        g.fill(new Rectangle2D.Double(5.8, 3.5, 4.4, 3.5));
        lines(g, 6.2, 9.5, 6.3, 9.5, 8, 9.5, 8.1, 9.5, 9.8, 9.5, 9.9, 9.5, 6.2, 12, 6.3, 12, 8, 12, 8.1, 12);
    }

    private static void robot(Graphics2D g) {
        path(g, false, 5, 2.5, 11, 2.5, 13.5, 6, 13.5, 11, 11, 13.5, 5, 13.5, 2.5, 11, 2.5, 6, 5, 2.5);
        path(g, true, 8, 4, 10.2, 7.2, 5.8, 7.2);
    }

    private static void trail(Graphics2D g) {
        var path = new Path2D.Double();
        path.moveTo(2.5, 13);
        path.curveTo(3, 5, 9.5, 14, 10.5, 5.5);
        g.draw(path);
        g.fill(new Ellipse2D.Double(8.8, 1.8, 3.6, 3.6));
    }

    private static void corners(Graphics2D g) {
        path(g, false, 2.5, 6, 2.5, 2.5, 6, 2.5);
        path(g, false, 10, 2.5, 13.5, 2.5, 13.5, 6);
        path(g, false, 13.5, 10, 13.5, 13.5, 10, 13.5);
        path(g, false, 6, 13.5, 2.5, 13.5, 2.5, 10);
    }

    private static void wave(Graphics2D g) {
        var path = new Path2D.Double();
        path.moveTo(1.5, 8);
        for (int i = 1; i <= 26; i++) {
            path.lineTo(1.5 + i * 0.5, 8 - 4.5 * Math.sin(i * 0.5 * Math.PI / 3.25));
        }
        g.draw(path);
    }

    private static void broadcast(Graphics2D g) {
        g.fill(new Ellipse2D.Double(6.4, 5.4, 3.2, 3.2));
        lines(g, 8, 9, 8, 14);
        g.draw(new Arc2D.Double(3.5, 2.5, 9, 9, -45, 90, Arc2D.OPEN));
        g.draw(new Arc2D.Double(3.5, 2.5, 9, 9, 135, 90, Arc2D.OPEN));
        g.draw(new Arc2D.Double(1, 0, 14, 14, -40, 80, Arc2D.OPEN));
        g.draw(new Arc2D.Double(1, 0, 14, 14, 140, 80, Arc2D.OPEN));
    }

    private static void lines(Graphics2D g, double... xy) {
        for (int i = 0; i + 3 < xy.length; i += 4) {
            g.draw(new Line2D.Double(xy[i], xy[i + 1], xy[i + 2], xy[i + 3]));
        }
    }

    private static void path(Graphics2D g, boolean filled, double... xy) {
        var path = new Path2D.Double();
        path.moveTo(xy[0], xy[1]);
        for (int i = 2; i < xy.length; i += 2) {
            path.lineTo(xy[i], xy[i + 1]);
        }
        if (filled) {
            path.closePath();
            g.fill(path);
        } else {
            g.setStroke(PEN);
            g.draw(path);
        }
    }
}
