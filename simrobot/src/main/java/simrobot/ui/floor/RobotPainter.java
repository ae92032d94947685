package simrobot.ui.floor;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.Theme;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SonarRing;
import simrobot.robot.Trail;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.StatusLook;
import vericommand.RobotStatus;

/** Paints a robot: the way it came, what its sonars hear, its body. Shapes are in metres about its centre of rotation. */
final class RobotPainter {
    /** Where the handle sits by which a selected robot is turned, metres ahead. */
    static final double HANDLE_METERS = 0.48;

    private static final Shape BODY = body();
    private static final double OUTLINE_METERS = 0.012;

    private final Graphics2D g;
    private final Viewport view;

    RobotPainter(Graphics2D g, Viewport view) {
        this.g = g;
        this.view = view;
    }

    private static Shape body() {
        Path2D path = new Path2D.Double();
        for (double[] corner : Pioneer2Dx.octagon()) {
            if (path.getCurrentPoint() == null) {
                path.moveTo(corner[0], corner[1]);
            } else {
                path.lineTo(corner[0], corner[1]);
            }
        }
        path.closePath();
        return path;
    }

    // ---- trail -----------------------------------------------------------------------------------------------------

    /** The newest part is strong, after a minute of simulated time it is faint, but it never vanishes. */
    void trail(RobotSnapshot robot, long nowNanos) {
        Trail.Points points = robot.trail();
        g.setStroke(Theme.stroke(1.8));
        int last = points.size() - 1;
        for (int from = 0; from < last; ) {
            double opacity = opacity(nowNanos - points.timesNanos()[from]);
            Path2D path = new Path2D.Double();
            int to = from;
            while (to < last && opacity(nowNanos - points.timesNanos()[to]) == opacity) {
                leg(path, points, to++);
            }
            g.setColor(Theme.color(Ink.TRAIL, opacity));
            g.draw(path);
            from = to;
        }
    }

    /** In a few steps, so that a trail is a few lines to draw. */
    private static double opacity(long ageNanos) {
        double fade = Math.exp(-ageNanos / 40e9);
        return 0.14 + 0.66 * Math.ceil(fade * 10) / 10;
    }

    private void leg(Path2D path, Trail.Points points, int i) {
        double[] xy = points.xy();
        double x1 = view.screenX(xy[2 * i]);
        double y1 = view.screenY(xy[2 * i + 1]);
        double x2 = view.screenX(xy[2 * i + 2]);
        double y2 = view.screenY(xy[2 * i + 3]);
        if (!Double.isNaN(x1) && !Double.isNaN(x2)) {
            path.moveTo(x1, y1);
            path.lineTo(x2, y2);
        }
    }

    // ---- sonar -----------------------------------------------------------------------------------------------------

    /** A thin cone as far as the echo, its arc where the echo came from; no echo is a mere hint of a ray. */
    void sonar(RobotSnapshot robot) {
        double[] ranges = robot.sonarRangesMeters();
        for (int i = 0; i < ranges.length; i++) {
            boolean echo = ranges[i] < Pioneer2Dx.SONAR_RANGE_METERS;
            double direction = robot.headingRadians() + SonarRing.directionRadians(i);
            double x = mouthX(robot, i);
            double y = mouthY(robot, i);
            if (echo) {
                cone(x, y, direction, ranges[i]);
            }
            g.setColor(Theme.color(Ink.RAY, echo ? 0.55 : 0.16));
            g.setStroke(Theme.stroke(0.8));
            Drawing.line(
                    g,
                    view.screenX(x),
                    view.screenY(y),
                    view.screenX(x + ranges[i] * Math.cos(direction)),
                    view.screenY(y + ranges[i] * Math.sin(direction)));
        }
    }

    private void cone(double x, double y, double direction, double range) {
        Path2D arc = new Path2D.Double();
        int steps = 6;
        for (int k = 0; k <= steps; k++) {
            double angle = direction + Pioneer2Dx.SONAR_CONE_RADIANS * ((double) k / steps - 0.5);
            double px = view.screenX(x + range * Math.cos(angle));
            double py = view.screenY(y + range * Math.sin(angle));
            if (k == 0) {
                arc.moveTo(px, py);
            } else {
                arc.lineTo(px, py);
            }
        }
        Path2D wedge = new Path2D.Double(arc);
        wedge.lineTo(view.screenX(x), view.screenY(y));
        wedge.closePath();
        g.setColor(Theme.color(Ink.RAY, 0.08));
        g.fill(wedge);
        g.setColor(Theme.color(Ink.RAY, 0.9));
        g.setStroke(Theme.stroke(1.6));
        g.draw(arc);
    }

    private static double mouthX(RobotSnapshot robot, int sonar) {
        double heading = robot.headingRadians();
        return robot.xMeters()
                + SonarRing.mountX(sonar) * Math.cos(heading)
                - SonarRing.mountY(sonar) * Math.sin(heading);
    }

    private static double mouthY(RobotSnapshot robot, int sonar) {
        double heading = robot.headingRadians();
        return robot.yMeters()
                + SonarRing.mountX(sonar) * Math.sin(heading)
                + SonarRing.mountY(sonar) * Math.cos(heading);
    }

    // ---- body ------------------------------------------------------------------------------------------------------

    void body(RobotSnapshot robot, boolean selected) {
        AffineTransform before = g.getTransform();
        g.translate(view.screenX(robot.xMeters()), view.screenY(robot.yMeters()));
        g.rotate(-robot.headingRadians());
        g.scale(view.pixelsPerMeter(), -view.pixelsPerMeter());
        if (selected) {
            selection();
        }
        if (robot.status() == RobotStatus.COLLISION) {
            contact();
        }
        g.setColor(Theme.color(paint(robot)));
        g.fill(BODY);
        g.setColor(Theme.color(Ink.ROBOT_LINE));
        g.setStroke(meters(Math.max(OUTLINE_METERS, pixels(1.2))));
        g.draw(BODY);
        wheels();
        deck();
        g.setTransform(before);
    }

    /** A robot that is not there, dashed; crossed out where it may not stand. */
    void ghost(RobotGhost ghost) {
        double x = view.screenX(ghost.xMeters());
        double y = view.screenY(ghost.yMeters());
        double r = Pioneer2Dx.RADIUS_METERS * view.pixelsPerMeter();
        AffineTransform before = g.getTransform();
        g.translate(x, y);
        g.rotate(-ghost.headingRadians());
        g.setColor(Theme.color(ghost.ink(), 0.14));
        g.fill(circle(0, 0, r));
        g.setColor(Theme.color(ghost.ink()));
        g.setStroke(Theme.dashed(1.6, 4));
        g.draw(circle(0, 0, r));
        g.draw(new Line2D.Double(0, 0, r + Theme.exact(10), 0));
        g.setTransform(before);
        if (ghost.refused()) {
            g.setStroke(Theme.stroke(2));
            double arm = Math.max(Theme.exact(5), r * 0.55);
            Drawing.line(g, x - arm, y - arm, x + arm, y + arm);
            Drawing.line(g, x - arm, y + arm, x + arm, y - arm);
        }
        if (!ghost.text().isEmpty()) {
            caption(ghost.text(), x, y + Math.max(r, Theme.exact(8)) + Theme.exact(16), ghost.ink());
        }
    }

    /** On a ground of its own, so that it can be read across walls. */
    private void caption(String text, double x, double y, Ink ink) {
        double width = Drawing.width(Theme.strong(), text) + Theme.exact(16);
        double left = Math.max(Theme.exact(4), Math.min(view.width() - width - Theme.exact(4), x - width / 2));
        g.setColor(Theme.color(Ink.CARD));
        g.fill(Drawing.round(left, y - Theme.exact(11), width, Theme.exact(22), Theme.exact(Theme.CONTROL_RADIUS)));
        g.setColor(Theme.color(ink));
        g.setStroke(Theme.hairline());
        g.draw(Drawing.round(left, y - Theme.exact(11), width, Theme.exact(22), Theme.exact(Theme.CONTROL_RADIUS)));
        Drawing.centred(g, text, Theme.strong(), left + width / 2, y);
    }

    /** A robot without power is grey; a shape beside it says why, see {@link #badge}. */
    private static Ink paint(RobotSnapshot robot) {
        return robot.powered() ? Ink.ROBOT : Ink.DISABLED;
    }

    private void selection() {
        double r = Pioneer2Dx.RADIUS_METERS + 0.05;
        g.setColor(Theme.color(Ink.ACCENT, 0.10));
        g.fill(circle(0, 0, r));
        g.setColor(Theme.color(Ink.ACCENT, 0.9));
        g.setStroke(meters(pixels(1.4)));
        g.draw(circle(0, 0, r));
        double handle = Math.max(0.035, pixels(4.5));
        g.draw(new Line2D.Double(r, 0, HANDLE_METERS - handle, 0));
        g.setColor(Theme.color(Ink.CARD));
        g.fill(circle(HANDLE_METERS, 0, handle));
        g.setColor(Theme.color(Ink.ACCENT));
        g.draw(circle(HANDLE_METERS, 0, handle));
    }

    /** The circle that touches. */
    private void contact() {
        g.setColor(Theme.color(Ink.DANGER, 0.16));
        g.fill(circle(0, 0, Pioneer2Dx.RADIUS_METERS));
        g.setColor(Theme.color(Ink.DANGER));
        g.setStroke(meters(pixels(1.6)));
        g.draw(circle(0, 0, Pioneer2Dx.RADIUS_METERS));
    }

    private void wheels() {
        g.setColor(Theme.color(Ink.WHEEL));
        double d = Pioneer2Dx.WHEEL_DIAMETER_METERS;
        double w = Pioneer2Dx.WHEEL_WIDTH_METERS;
        for (int side = -1; side <= 1; side += 2) {
            g.fill(new RoundRectangle2D.Double(-d / 2, side * Pioneer2Dx.TRACK_METERS / 2 - w / 2, d, w, w / 2, w / 2));
        }
    }

    /** The heading mark, the axle and the sonars' mouths. */
    private void deck() {
        g.setColor(Theme.color(Ink.ROBOT_LINE, 0.5));
        g.setStroke(meters(Math.max(0.006, pixels(0.8))));
        g.draw(new Line2D.Double(0, -Pioneer2Dx.TRACK_METERS / 2, 0, Pioneer2Dx.TRACK_METERS / 2));
        for (int i = 0; i < SonarRing.COUNT; i++) {
            double pull = 0.93;
            double x = Pioneer2Dx.BODY_MIDDLE_X_METERS + (SonarRing.mountX(i) - Pioneer2Dx.BODY_MIDDLE_X_METERS) * pull;
            g.fill(circle(x, SonarRing.mountY(i) * pull, 0.011));
        }
        nose(g);
    }

    private static void nose(Graphics2D g) {
        Path2D nose = new Path2D.Double();
        nose.moveTo(0.15, 0);
        nose.lineTo(0.02, 0.075);
        nose.lineTo(0.055, 0);
        nose.lineTo(0.02, -0.075);
        nose.closePath();
        g.setColor(Theme.color(Ink.ON_SIGNAL));
        g.fill(nose);
    }

    /** The status as a shape beside the robot, and its name where there are several; both upright. */
    void badge(RobotSnapshot robot, boolean named) {
        double x = view.screenX(robot.xMeters());
        double y = view.screenY(robot.yMeters());
        double reach = Math.max(Theme.exact(12), 0.36 * view.pixelsPerMeter());
        if (robot.status() != RobotStatus.STOPPED && robot.status() != RobotStatus.MOVING) {
            double r = Theme.exact(6);
            double bx = x + reach * 0.8;
            double by = y - reach * 0.8;
            g.setColor(Theme.color(Ink.CARD));
            g.fill(circle(bx, by, r + Theme.exact(3)));
            g.setColor(Theme.color(Ink.LINE));
            g.setStroke(Theme.hairline());
            g.draw(circle(bx, by, r + Theme.exact(3)));
            StatusLook.mark(robot.status()).draw(new GraphicsCanvas(g), bx, by, r, StatusLook.ink(robot.status()));
        }
        if (named) {
            g.setColor(Theme.color(Ink.TEXT));
            Drawing.centred(g, robot.name(), Theme.small(), x, y - reach - Theme.exact(6));
        }
    }

    private double pixels(double units) {
        return Theme.exact(units) / view.pixelsPerMeter();
    }

    private static Stroke meters(double width) {
        return new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    private static Shape circle(double x, double y, double r) {
        return new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r);
    }
}
