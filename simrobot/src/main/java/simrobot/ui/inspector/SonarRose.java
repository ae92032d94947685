package simrobot.ui.inspector;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.util.Arrays;
import java.util.stream.DoubleStream;
import javax.accessibility.AccessibleRole;
import simgsm.console.TextBundle;
import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.draw.Outline;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simrobot.drawing.NumberTexts;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SonarRing;

/**
 * The ranges of the sixteen sonars from above, ahead is up: a sector as long as the free distance, on a square-root scale, which
 * gives near distances more space. Echoes nearer than 0.5 m have another colour and a thicker arc.
 */
final class SonarRose extends PaintedComponent {
    private static final double NEAR_METERS = 0.5;
    private static final double[] RINGS_METERS = {1, 2, 5};
    private static final double SECTOR_RADIANS = Math.toRadians(17);
    private static final int ARC_STEPS = 6;

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
    protected void paint(Graphics2D graphics, double width, double height) {
        Canvas g = new GraphicsCanvas(graphics);
        double caption = g.px(18);
        double radius = Math.min(width, height - caption) / 2 - g.px(8);
        g.moved(width / 2, (height - caption) / 2, 0, () -> {
            g.ink(Ink.LINE);
            g.pen(1);
            for (double meters : RINGS_METERS) {
                g.draw(Outline.circle(0, 0, length(meters, radius)));
            }
            for (int i = 0; i < ranges.length; i++) {
                sector(g, radius, i);
            }
            robot(g, radius);
        });
        g.ink(Ink.QUIET);
        g.text(spoken(), Face.SMALL, width / 2, height - caption / 2);
    }

    private static double length(double meters, double radius) {
        return radius * Math.sqrt(Math.min(1, meters / Pioneer2Dx.SONAR_RANGE_METERS));
    }

    private void sector(Canvas g, double radius, int sonar) {
        // from the robot's centre, so that a near echo is drawn just outside its body
        double mouth = Math.hypot(SonarRing.mountX(sonar), SonarRing.mountY(sonar));
        double r = length(mouth + ranges[sonar], radius);
        boolean echo = ranges[sonar] < Pioneer2Dx.SONAR_RANGE_METERS;
        boolean near = ranges[sonar] < NEAR_METERS;
        double[] arc = new double[2 * (ARC_STEPS + 1)];
        for (int k = 0; k <= ARC_STEPS; k++) {
            double angle = SonarRing.directionRadians(sonar) + SECTOR_RADIANS * ((double) k / ARC_STEPS - 0.5);
            arc[2 * k] = -r * Math.sin(angle);
            arc[2 * k + 1] = -r * Math.cos(angle);
        }
        Ink ink = !echo ? Ink.QUIET : near ? Ink.DANGER : Ink.RAY;
        g.ink(ink, echo ? 0.16 : 0.05);
        g.fill(Outline.polyline(arc).line(0, 0).close());
        if (echo) {
            g.ink(ink);
            g.pen(near ? 2.6 : 1.6);
            g.draw(Outline.polyline(arc));
        }
    }

    private static void robot(Canvas g, double radius) {
        double scale = length(Pioneer2Dx.RADIUS_METERS, radius) / Pioneer2Dx.RADIUS_METERS;
        double[] body = Arrays.stream(Pioneer2Dx.octagon())
                .flatMapToDouble(corner -> DoubleStream.of(-corner[1], Pioneer2Dx.BODY_MIDDLE_X_METERS - corner[0]))
                .toArray();
        Outline outline = Outline.polygon(body).placed(0, 0, 0.9 * scale);
        g.ink(Ink.CARD);
        g.fill(outline);
        g.ink(Ink.ROBOT);
        g.pen(1.6);
        g.draw(outline);
        g.fill(Outline.polygon(0, -0.12, 0.06, 0, -0.06, 0).placed(0, 0, scale));
    }
}
