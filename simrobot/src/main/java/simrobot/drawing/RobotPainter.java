package simrobot.drawing;

import java.util.Arrays;
import java.util.List;
import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.draw.Outline;
import simrobot.behaviour.BehaviourRequest;
import simrobot.robot.Laser;
import simrobot.robot.LaserField;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SonarRing;
import simrobot.robot.Trail;
import simrobot.simulation.RobotSnapshot;
import simrobot.world.Position;
import vericommand.RobotStatus;

/** Paints a robot: its trail, its sonar echoes, its body. */
public final class RobotPainter {
    /** Distance of a selected robot's turning handle from its centre of rotation. */
    public static final double HANDLE_METERS = 0.48;

    private static final double OUTLINE_METERS = 0.012;
    private static final int CONE_STEPS = 6;

    private final Canvas g;
    private final Viewport view;
    private final double scale;

    public RobotPainter(Canvas g, Viewport view) {
        this.g = g;
        this.view = view;
        scale = view.pixelsPerMeter();
    }

    // ---- trail -----------------------------------------------------------------------------------------------------

    /** The newest part has an opacity of 0.8; it fades by e in 40 s of simulated time, down to 0.14. */
    void trail(RobotSnapshot robot, long nowNanos) {
        Trail.Points points = robot.trail();
        g.pen(1.8);
        int last = points.size() - 1;
        for (int from = 0; from < last; ) {
            double opacity = opacity(nowNanos - points.timesNanos()[from]);
            Outline path = new Outline();
            int to = from;
            while (to < last && opacity(nowNanos - points.timesNanos()[to]) == opacity) {
                leg(path, points.xy(), 2 * to++);
            }
            g.ink(Ink.TRAIL, opacity);
            g.draw(path);
            from = to;
        }
    }

    /** Opacity in ten steps, so that a trail is at most eleven paths. */
    private static double opacity(long ageNanos) {
        double fade = Math.exp(-ageNanos / 40e9);
        return 0.14 + 0.66 * Math.ceil(fade * 10) / 10;
    }

    /** The line from one point to the next; NaN marks a lifted robot. */
    private void leg(Outline path, double[] xy, int i) {
        if (!Double.isNaN(xy[i]) && !Double.isNaN(xy[i + 2])) {
            path.move(view.screenX(xy[i]), view.screenY(xy[i + 1]));
            path.line(view.screenX(xy[i + 2]), view.screenY(xy[i + 3]));
        }
    }

    // ---- path ------------------------------------------------------------------------------------------------------

    /** Draws the planned path of its process, with a ring at its end. */
    void path(RobotSnapshot robot) {
        List<Position> path = robot.path();
        if (path.isEmpty()) {
            return;
        }
        Outline line = new Outline();
        line.move(view.screenX(robot.xMeters()), view.screenY(robot.yMeters()));
        path.forEach(place -> line.line(view.screenX(place.xMeters()), view.screenY(place.yMeters())));
        Position goal = path.get(path.size() - 1);
        g.ink(Ink.ACCENT, 0.8);
        g.pen(2.4);
        g.draw(line);
        double radius = 0.25 * scale;
        g.draw(Outline.round(
                view.screenX(goal.xMeters()) - radius,
                view.screenY(goal.yMeters()) - radius,
                2 * radius,
                2 * radius,
                radius));
    }

    /** Draws the lines and texts of its process. */
    void marks(RobotSnapshot robot) {
        g.ink(Ink.GOOD);
        g.pen(2);
        for (BehaviourRequest.Mark mark : robot.marks()) {
            double x = view.screenX(mark.x());
            double y = view.screenY(mark.y());
            if (mark.text().isEmpty()) {
                g.line(x, y, view.screenX(mark.toX()), view.screenY(mark.toY()));
            } else {
                g.text(mark.text(), Face.SMALL, x, y);
            }
        }
    }

    // ---- sonar -----------------------------------------------------------------------------------------------------

    /** Draws a thin cone to the echo with an arc at its end; without an echo a faint ray. */
    void sonar(RobotSnapshot robot) {
        double[] ranges = robot.sonarRangesMeters();
        double cos = Math.cos(robot.headingRadians());
        double sin = Math.sin(robot.headingRadians());
        for (int i = 0; i < ranges.length; i++) {
            boolean echo = ranges[i] < Pioneer2Dx.SONAR_RANGE_METERS;
            double direction = robot.headingRadians() + SonarRing.directionRadians(i);
            double mountX = SonarRing.mountX(i);
            double mountY = SonarRing.mountY(i);
            double x = view.screenX(robot.xMeters() + mountX * cos - mountY * sin);
            double y = view.screenY(robot.yMeters() + mountX * sin + mountY * cos);
            double length = ranges[i] * scale;
            if (echo) {
                cone(x, y, direction, length);
            }
            g.ink(Ink.RAY, echo ? 0.55 : 0.16);
            g.pen(0.8);
            g.line(x, y, x + length * Math.cos(direction), y - length * Math.sin(direction));
        }
    }

    /** Draws the area seen by the laser, with a border at the echoes. */
    void laser(RobotSnapshot robot) {
        double[] ranges = robot.laserRangesMeters();
        if (ranges.length == 0) {
            return;
        }
        double x = view.screenX(robot.xMeters() + Laser.MOUNT_METERS * Math.cos(robot.headingRadians()));
        double y = view.screenY(robot.yMeters() + Laser.MOUNT_METERS * Math.sin(robot.headingRadians()));
        double[] border = new double[2 * ranges.length];
        for (int i = 0; i < ranges.length; i++) {
            double direction = robot.headingRadians() + LaserField.USUAL.radians(i);
            border[2 * i] = x + ranges[i] * scale * Math.cos(direction);
            border[2 * i + 1] = y - ranges[i] * scale * Math.sin(direction);
        }
        g.ink(Ink.ACCENT, 0.1);
        g.fill(Outline.polyline(border).line(x, y).close());
        g.ink(Ink.ACCENT, 0.8);
        for (int i = 0; i < ranges.length; i++) {
            if (ranges[i] < Laser.RANGE_METERS) {
                g.bar(border[2 * i] - g.px(1), border[2 * i + 1] - g.px(1), g.px(2), g.px(2));
            }
        }
    }

    private void cone(double x, double y, double direction, double length) {
        double[] arc = new double[2 * (CONE_STEPS + 1)];
        for (int k = 0; k <= CONE_STEPS; k++) {
            double angle = direction + Pioneer2Dx.SONAR_CONE_RADIANS * ((double) k / CONE_STEPS - 0.5);
            arc[2 * k] = x + length * Math.cos(angle);
            arc[2 * k + 1] = y - length * Math.sin(angle);
        }
        g.ink(Ink.RAY, 0.08);
        g.fill(Outline.polyline(arc).line(x, y).close());
        g.ink(Ink.RAY, 0.9);
        g.pen(1.6);
        g.draw(Outline.polyline(arc));
    }

    // ---- body: ahead is to the right, about the centre of rotation -------------------------------------------------

    void body(RobotSnapshot robot, boolean selected) {
        at(robot.xMeters(), robot.yMeters(), robot.headingRadians(), () -> {
            if (selected) {
                selection();
            }
            if (robot.status() == RobotStatus.COLLISION) {
                contact();
            }
            body(robot.powered() ? Ink.ROBOT : Ink.DISABLED);
        });
    }

    private void at(double xMeters, double yMeters, double headingRadians, Runnable inside) {
        g.moved(view.screenX(xMeters), view.screenY(yMeters), -headingRadians, inside);
    }

    /** Draws a robot and its name, moved in one coordinate system and turned in another inside it. */
    void movable(RobotSnapshot robot) {
        at(robot.xMeters(), robot.yMeters(), 0, () -> {
            g.moved(0, 0, -robot.headingRadians(), () -> body(Ink.ROBOT));
            name(robot, 0, 0);
        });
    }

    private void name(RobotSnapshot robot, double x, double y) {
        g.ink(Ink.TEXT);
        g.text(robot.name(), Face.SMALL, x, y - reach() - g.px(6));
    }

    /** Distance of a robot's name and status mark from its centre, pixels. */
    private double reach() {
        return Math.max(g.px(12), 0.36 * scale);
    }

    /** The body with wheels, axle, sonars and heading mark, at the origin. */
    private void body(Ink ink) {
        Outline body = Outline.polygon(Arrays.stream(Pioneer2Dx.octagon())
                        .flatMapToDouble(Arrays::stream)
                        .toArray())
                .placed(0, 0, scale);
        g.ink(ink);
        g.fill(body);
        g.ink(Ink.ROBOT_LINE);
        pen(1.2, OUTLINE_METERS);
        g.draw(body);
        wheels();
        deck();
    }

    /** Sets a pen to a width in units, or in metres if that is wider. */
    private void pen(double units, double meters) {
        g.pen(Math.max(units, meters * scale / g.px(1)));
    }

    private void selection() {
        double r = (Pioneer2Dx.RADIUS_METERS + 0.05) * scale;
        g.ink(Ink.ACCENT, 0.10);
        g.fill(Outline.circle(0, 0, r));
        g.ink(Ink.ACCENT, 0.9);
        g.pen(1.4);
        g.draw(Outline.circle(0, 0, r));
        double knob = Math.max(0.035 * scale, g.px(4.5));
        double at = HANDLE_METERS * scale;
        g.line(r, 0, at - knob, 0);
        g.ink(Ink.CARD);
        g.fill(Outline.circle(at, 0, knob));
        g.ink(Ink.ACCENT);
        g.draw(Outline.circle(at, 0, knob));
    }

    /** Draws the collision circle. */
    private void contact() {
        Outline circle = Outline.circle(0, 0, Pioneer2Dx.RADIUS_METERS * scale);
        g.ink(Ink.DANGER, 0.16);
        g.fill(circle);
        g.ink(Ink.DANGER);
        g.pen(1.6);
        g.draw(circle);
    }

    private void wheels() {
        double length = Pioneer2Dx.WHEEL_DIAMETER_METERS * scale;
        double width = Pioneer2Dx.WHEEL_WIDTH_METERS * scale;
        double away = Pioneer2Dx.TRACK_METERS / 2 * scale;
        g.ink(Ink.WHEEL);
        g.fill(Outline.round(-length / 2, away - width / 2, length, width, width / 4));
        g.fill(Outline.round(-length / 2, -away - width / 2, length, width, width / 4));
    }

    /** The axle, the sonars' mouths and the heading mark. */
    private void deck() {
        double away = Pioneer2Dx.TRACK_METERS / 2 * scale;
        g.ink(Ink.ROBOT_LINE, 0.5);
        pen(0.8, 0.006);
        g.line(0, -away, 0, away);
        double pull = 0.93;
        for (int i = 0; i < SonarRing.COUNT; i++) {
            double x = Pioneer2Dx.BODY_MIDDLE_X_METERS + (SonarRing.mountX(i) - Pioneer2Dx.BODY_MIDDLE_X_METERS) * pull;
            g.fill(Outline.circle(x * scale, -SonarRing.mountY(i) * pull * scale, 0.011 * scale));
        }
        g.ink(Ink.ON_SIGNAL);
        g.fill(Outline.parse("M.15 0L.02 .075L.055 0L.02 -.075Z").placed(0, 0, scale));
    }

    /** Draws a dashed circle with a heading; crossed out if the place is refused. */
    public void preview(RobotPreview preview) {
        double r = Pioneer2Dx.RADIUS_METERS * scale;
        at(preview.xMeters(), preview.yMeters(), preview.headingRadians(), () -> {
            g.ink(preview.ink(), 0.14);
            g.fill(Outline.circle(0, 0, r));
            g.ink(preview.ink());
            g.pen(1.6, 4);
            g.draw(Outline.circle(0, 0, r));
            g.line(0, 0, r + g.px(10), 0);
        });
        double x = view.screenX(preview.xMeters());
        double y = view.screenY(preview.yMeters());
        if (preview.refused()) {
            double arm = Math.max(g.px(5), r * 0.55);
            g.ink(preview.ink());
            g.pen(2);
            g.line(x - arm, y - arm, x + arm, y + arm);
            g.line(x - arm, y + arm, x + arm, y - arm);
        }
        if (!preview.text().isEmpty()) {
            double width = g.width(preview.text(), Face.STRONG) + g.px(16);
            double left = Math.max(g.px(4), Math.min(view.width() - width - g.px(4), x - width / 2));
            double top = y + Math.max(r, g.px(8)) + g.px(5);
            Outline ground = WorldPainter.textGround(g, Ink.CARD, 1, left, top, width, g.px(22));
            g.ink(preview.ink());
            g.pen(1);
            g.draw(ground);
            g.text(preview.text(), Face.STRONG, left + width / 2, top + g.px(11));
        }
    }

    /** Draws the status as a mark above the robot, and its name if there are several; both upright. */
    void badge(RobotSnapshot robot, boolean named) {
        double x = view.screenX(robot.xMeters());
        double y = view.screenY(robot.yMeters());
        if (robot.status() != RobotStatus.STOPPED && robot.status() != RobotStatus.MOVING) {
            double r = g.px(6);
            double bx = x + reach() * 0.8;
            double by = y - reach() * 0.8;
            Outline ground = Outline.circle(bx, by, r + g.px(3));
            g.ink(Ink.CARD);
            g.fill(ground);
            g.ink(Ink.LINE);
            g.pen(1);
            g.draw(ground);
            StatusLook.mark(robot.status()).draw(g, bx, by, r, StatusLook.ink(robot.status()));
        }
        if (named) {
            name(robot, x, y);
        }
    }
}
