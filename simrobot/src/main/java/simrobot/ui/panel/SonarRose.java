package simrobot.ui.panel;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.Arrays;
import javax.accessibility.AccessibleRole;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simrobot.drawing.NumberTexts;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SonarRing;

/**
 * The sixteen sonars seen from above, ahead is up: a sector as long as the way is free. Distances run with their square
 * root, so that the near ones, which matter, have room. Near ones are hatched in colour and named by number.
 */
final class SonarRose extends PaintedComponent {
    private static final double NEAR_METERS = 0.5;
    private static final double[] RINGS_METERS = {1, 2, 5};
    private static final double SECTOR_DEGREES = 17;

    private final TextBundle texts;
    private double[] ranges = new double[0];

    SonarRose(TextBundle texts) {
        super(AccessibleRole.LABEL);
        setName("sonar");
        this.texts = texts;
    }

    /** @param newRanges sixteen ranges in metres, or none */
    void show(double[] newRanges) {
        if (!Arrays.equals(ranges, newRanges)) {
            change(() -> ranges = newRanges);
            repaint();
        }
    }

    @Override
    protected String spoken() {
        int nearest = nearest();
        return nearest < 0 || ranges[nearest] >= Pioneer2Dx.SONAR_RANGE_METERS
                ? texts.of("sonar.none")
                : texts.of("sonar.nearest", nearest, NumberTexts.fixed(ranges[nearest], 2));
    }

    private int nearest() {
        int nearest = -1;
        for (int i = 0; i < ranges.length; i++) {
            if (nearest < 0 || ranges[i] < ranges[nearest]) {
                nearest = i;
            }
        }
        return nearest;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(196), Theme.px(190));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(110), Theme.px(110));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double caption = Theme.exact(18);
        double radius = Math.min(width, height - caption) / 2 - Theme.exact(8);
        double x = width / 2;
        double y = (height - caption) / 2;
        rings(g, x, y, radius);
        for (int i = 0; i < ranges.length; i++) {
            sector(g, x, y, radius, i);
        }
        robot(g, x, y, radius);
        g.setColor(Theme.color(Ink.QUIET));
        Drawing.centred(g, spoken(), Theme.small(), x, height - caption / 2);
    }

    private static double reach(double meters, double radius) {
        return radius * Math.sqrt(Math.min(1, meters / Pioneer2Dx.SONAR_RANGE_METERS));
    }

    private static void rings(Graphics2D g, double x, double y, double radius) {
        for (double meters : RINGS_METERS) {
            double r = reach(meters, radius);
            g.setColor(Theme.color(Ink.LINE));
            g.setStroke(Theme.hairline());
            g.draw(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r));
        }
    }

    private void sector(Graphics2D g, double x, double y, double radius, int sonar) {
        // from the middle of the robot, so that a near echo lies just outside its body
        double mouth = Math.hypot(SonarRing.mountX(sonar), SonarRing.mountY(sonar));
        double r = reach(mouth + ranges[sonar], radius);
        boolean echo = ranges[sonar] < Pioneer2Dx.SONAR_RANGE_METERS;
        Ink ink = !echo ? Ink.QUIET : ranges[sonar] < NEAR_METERS ? Ink.DANGER : Ink.RAY;
        double middle = 90 + Math.toDegrees(SonarRing.directionRadians(sonar));
        Arc2D sector =
                new Arc2D.Double(x - r, y - r, 2 * r, 2 * r, middle - SECTOR_DEGREES / 2, SECTOR_DEGREES, Arc2D.PIE);
        g.setColor(Theme.color(ink, echo ? 0.16 : 0.05));
        g.fill(sector);
        if (echo) {
            sector.setArcType(Arc2D.OPEN);
            g.setColor(Theme.color(ink));
            g.setStroke(Theme.stroke(ranges[sonar] < NEAR_METERS ? 2.6 : 1.6));
            g.draw(sector);
        }
    }

    private static void robot(Graphics2D g, double x, double y, double radius) {
        double scale = reach(Pioneer2Dx.RADIUS_METERS, radius) / Pioneer2Dx.RADIUS_METERS;
        Path2D body = new Path2D.Double();
        for (double[] corner : Pioneer2Dx.octagon()) {
            double px = x - corner[1] * scale * 0.9;
            double py = y - (corner[0] - Pioneer2Dx.BODY_MIDDLE_X_METERS) * scale * 0.9;
            if (body.getCurrentPoint() == null) {
                body.moveTo(px, py);
            } else {
                body.lineTo(px, py);
            }
        }
        body.closePath();
        g.setColor(Theme.color(Ink.CARD));
        g.fill(body);
        g.setColor(Theme.color(Ink.ROBOT));
        g.setStroke(Theme.stroke(1.6));
        g.draw(body);
        double tip = 0.12 * scale;
        Path2D nose = new Path2D.Double();
        nose.moveTo(x, y - tip);
        nose.lineTo(x + tip * 0.5, y);
        nose.lineTo(x - tip * 0.5, y);
        nose.closePath();
        g.fill(nose);
    }
}
