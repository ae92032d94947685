package simrobot.ui.floor;

import java.awt.Graphics2D;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.World;

/** Paints a snapshot of the simulation into a viewport; it has no state, so it serves screen, files and tests alike. */
final class WorldPainter {
    private WorldPainter() {}

    /**
     * Paints everything.
     *
     * @param selected the selected robot's name, or null
     */
    static void paint(Graphics2D g, SimulationSnapshot picture, Viewport view, Layers layers, String selected) {
        Drawing.prepare(g);
        floor(g, picture.world(), view, layers);
        robots(g, picture, view, layers, selected);
    }

    /** The part that stays as it is while robots move. */
    static void floor(Graphics2D g, World world, Viewport view, Layers layers) {
        FloorPainter floor = new FloorPainter(g, view);
        floor.paper();
        if (layers.grid()) {
            floor.grid();
        }
        floor.markings(world);
        floor.obstacles(world);
        scaleBar(g, view);
        axes(g, view);
    }

    /** The part that moves: belts, trails, sonar, robots. */
    static void robots(Graphics2D g, SimulationSnapshot picture, Viewport view, Layers layers, String selected) {
        new FloorPainter(g, view).treadmills(picture.world(), picture.timeNanos());
        RobotPainter painter = new RobotPainter(g, view);
        boolean alone = picture.robots().size() == 1;
        for (RobotSnapshot robot : picture.robots()) {
            if (layers.trail()) {
                painter.trail(robot, picture.timeNanos());
            }
        }
        for (RobotSnapshot robot : picture.robots()) {
            if (layers.sonar() && (alone || robot.name().equals(selected))) {
                painter.sonar(robot);
            }
        }
        for (RobotSnapshot robot : picture.robots()) {
            if (view.shows(robot.xMeters(), robot.yMeters(), 1)) {
                painter.body(robot, robot.name().equals(selected));
                painter.badge(robot, !alone);
            }
        }
    }

    /** Which way x and y run; headings count anticlockwise from x. */
    private static void axes(Graphics2D g, Viewport view) {
        double x = Theme.exact(18);
        double y = view.height() - Theme.exact(46);
        double length = Theme.exact(24);
        g.setColor(Theme.color(Ink.QUIET));
        g.setStroke(Theme.stroke(1.2));
        arrow(g, x, y, 1, 0, length);
        arrow(g, x, y, 0, -1, length);
        Drawing.centred(g, "x", Theme.monoSmall(), x + length + Theme.exact(8), y);
        Drawing.centred(g, "y", Theme.monoSmall(), x, y - length - Theme.exact(8));
    }

    private static void arrow(Graphics2D g, double x, double y, double ux, double uy, double length) {
        double tipX = x + ux * length;
        double tipY = y + uy * length;
        double barb = Theme.exact(4);
        Drawing.line(g, x, y, tipX, tipY);
        Drawing.line(g, tipX, tipY, tipX - barb * (ux + uy), tipY - barb * (uy + ux));
        Drawing.line(g, tipX, tipY, tipX - barb * (ux - uy), tipY - barb * (uy - ux));
    }

    /** A bar of 1, 2 or 5 times a power of ten metres, about 100 pixels long. */
    private static void scaleBar(Graphics2D g, Viewport view) {
        double meters = scaleBarMeters(view.pixelsPerMeter());
        double length = meters * view.pixelsPerMeter();
        double x = Theme.exact(14);
        double y = view.height() - Theme.exact(14);
        double tick = Theme.exact(5);
        g.setColor(Theme.color(Ink.FLOOR, 0.8));
        g.fill(Drawing.round(
                x - Theme.exact(8),
                y - Theme.exact(22),
                length + Theme.exact(16),
                Theme.exact(30),
                Theme.exact(Theme.CONTROL_RADIUS)));
        g.setColor(Theme.color(Ink.TEXT));
        Drawing.horizontal(g, x, x + length, y);
        Drawing.vertical(g, x, y - tick, y + Theme.exact(1));
        Drawing.vertical(g, x + length - Theme.exact(1), y - tick, y + Theme.exact(1));
        Drawing.vertical(g, x + length / 2, y - tick / 2, y);
        Drawing.centred(g, label(meters), Theme.monoSmall(), x + length / 2, y - Theme.exact(12));
    }

    static double scaleBarMeters(double pixelsPerMeter) {
        double wanted = Theme.exact(110) / pixelsPerMeter;
        double power = Math.pow(10, Math.floor(Math.log10(wanted)));
        double share = wanted / power;
        return power * (share >= 5 ? 5 : share >= 2 ? 2 : 1);
    }

    private static String label(double meters) {
        return meters >= 1 ? Math.round(meters) + " m" : Math.round(meters * 100) + " cm";
    }
}
