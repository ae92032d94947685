package simrobot.drawing;

import java.util.List;
import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.draw.Outline;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.World;

/** Paints a snapshot of the simulation into a viewport. */
public final class WorldPainter {
    private WorldPainter() {}

    /**
     * Paints everything.
     *
     * @param selected the selected robot's name, or null
     */
    public static void paint(Canvas g, SimulationSnapshot scene, Viewport view, Layers layers, String selected) {
        floor(g, scene.world(), view, layers);
        robots(g, scene, view, layers, selected);
    }

    /** Paints the part that does not change while robots move. */
    public static void floor(Canvas g, World world, Viewport view, Layers layers) {
        ground(g, world, view, layers);
        legend(g, view);
    }

    /** Paints the floor without its legend: a part of a view shows the same as the whole view there. */
    public static void ground(Canvas g, World world, Viewport view, Layers layers) {
        FloorPainter floor = new FloorPainter(g, view, layers.names());
        floor.paper();
        if (layers.grid()) {
            floor.grid();
        }
        floor.markings(world);
        floor.obstacles(world);
    }

    /** Paints scale bar and axes, which do not move when the view is dragged. */
    public static void legend(Canvas g, Viewport view) {
        scaleBar(g, view);
        axes(g, view);
    }

    /** Paints the part that changes with the robots: surfaces, names of homes, trails, sonar echoes, robots. */
    public static void robots(Canvas g, SimulationSnapshot scene, Viewport view, Layers layers, String selected) {
        FloorPainter floor = new FloorPainter(g, view, layers.names());
        floor.surfaces(scene.world(), scene.timeNanos());
        boolean alone = scene.robots().size() == 1;
        floor.homeNames(scene.world(), alone ? List.of() : scene.robots());
        RobotPainter painter = new RobotPainter(g, view);
        scene.robots().forEach(painter::path);
        for (RobotSnapshot robot : scene.robots()) {
            if (layers.trail()) {
                painter.trail(robot, scene.timeNanos());
            }
            painter.marks(robot);
        }
        for (RobotSnapshot robot : scene.robots()) {
            if (layers.sonar() && (alone || robot.name().equals(selected))) {
                painter.laser(robot);
                painter.sonar(robot);
            }
        }
        for (RobotSnapshot robot : scene.robots()) {
            if (view.shows(robot.xMeters(), robot.yMeters(), 1)) {
                painter.body(robot, robot.name().equals(selected));
                painter.badge(robot, !alone);
            }
        }
    }

    /**
     * Paints treadmills at rest, other surfaces, names of homes, and each robot in a group {@code robot}, which a
     * script moves and turns.
     */
    public static void movableRobots(Canvas g, SimulationSnapshot scene, Viewport view, PlaceNames names) {
        FloorPainter floor = new FloorPainter(g, view, names);
        floor.surfaces(scene.world(), 0);
        floor.homeNames(scene.world(), scene.robots());
        RobotPainter painter = new RobotPainter(g, view);
        scene.robots().forEach(robot -> g.group("robot", () -> painter.movable(robot)));
    }

    /** Paints the directions of x and y; headings count anticlockwise from x. */
    private static void axes(Canvas g, Viewport view) {
        double x = g.px(18);
        double y = view.height() - g.px(46);
        double length = g.px(24);
        g.ink(Ink.QUIET);
        g.pen(1.2);
        arrow(g, x, y, 1, 0, length);
        arrow(g, x, y, 0, -1, length);
        g.text("x", Face.MONO_SMALL, x + length + g.px(8), y);
        g.text("y", Face.MONO_SMALL, x, y - length - g.px(8));
    }

    private static void arrow(Canvas g, double x, double y, double ux, double uy, double length) {
        double tipX = x + ux * length;
        double tipY = y + uy * length;
        double barb = g.px(4);
        g.line(x, y, tipX, tipY);
        g.line(tipX, tipY, tipX - barb * (ux + uy), tipY - barb * (uy + ux));
        g.line(tipX, tipY, tipX - barb * (ux - uy), tipY - barb * (uy - ux));
    }

    /** Paints a bar of 1, 2 or 5 times a power of ten metres, at most 110 units long. */
    private static void scaleBar(Canvas g, Viewport view) {
        double meters = scaleBarMeters(view.pixelsPerMeter() / g.px(1));
        double length = meters * view.pixelsPerMeter();
        double x = g.px(14);
        double y = view.height() - g.px(14);
        double tick = g.px(5);
        // Only behind the number: a wall covered along the whole bar would look like a gap.
        double width = g.width(label(meters), Face.MONO_SMALL) + g.px(8);
        textGround(g, Ink.FLOOR, 0.8, x + (length - width) / 2, y - g.px(20), width, g.px(15));
        g.ink(Ink.TEXT);
        g.bar(x, y, length, g.px(1));
        g.bar(x, y - tick, g.px(1), tick + g.px(1));
        g.bar(x + length - g.px(1), y - tick, g.px(1), tick + g.px(1));
        g.bar(x + length / 2, y - tick / 2, g.px(1), tick / 2);
        g.text(label(meters), Face.MONO_SMALL, x + length / 2, y - g.px(12));
    }

    /** @param pixelsPerMeter at zoom 1 */
    static double scaleBarMeters(double pixelsPerMeter) {
        double wanted = 110 / pixelsPerMeter;
        double power = Math.pow(10, Math.floor(Math.log10(wanted)));
        double share = wanted / power;
        return power * (share >= 5 ? 5 : share >= 2 ? 2 : 1);
    }

    private static String label(double meters) {
        return meters >= 1 ? Math.round(meters) + " m" : Math.round(meters * 100) + " cm";
    }

    /** Fills a rounded rectangle so that a text is legible over walls, and returns its outline. */
    public static Outline textGround(
            Canvas g, Ink ink, double opacity, double x, double y, double width, double height) {
        Outline ground = Outline.round(x, y, width, height, g.px(6));
        g.ink(ink, opacity);
        g.fill(ground);
        return ground;
    }
}
