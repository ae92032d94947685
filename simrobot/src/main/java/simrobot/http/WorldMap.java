package simrobot.http;

import java.util.Locale;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.draw.SvgCanvas;
import simrobot.drawing.Layers;
import simrobot.drawing.NumberTexts;
import simrobot.drawing.PlaceNames;
import simrobot.drawing.Viewport;
import simrobot.drawing.WorldPainter;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Area;
import simrobot.world.Segment;
import simrobot.world.World;

/**
 * The page's map: the window's picture of the floor as SVG, with a group for each robot that the page's script moves.
 * Its colours are variables of the page's style sheet.
 */
final class WorldMap {
    private static final double LONG_SIDE = 960;
    private static final double LEAST_SIDE = 200;
    private static final double MARGIN = 48;
    private static final double ROOM_SIDE = 360;
    private static final double ROOM_MARGIN = 20;
    private static final Layers SHOWN = new Layers(true, false, false);

    private WorldMap() {}

    /** The variables of the style sheet: {@code --wall:#2b3037;} and so on. */
    static String variables(Appearance appearance) {
        StringBuilder css = new StringBuilder();
        for (Ink ink : Ink.values()) {
            css.append(variable(ink)).append(':').append(ink.hex(appearance)).append(';');
        }
        return css.toString();
    }

    private static String variable(Ink ink) {
        return "--" + ink.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The rectangle up to the nearest walls in the directions of the axes; without a wall, up to the ground's edge. */
    static Area around(World world, double x, double y) {
        double left = world.ground().minXMeters();
        double right = world.ground().maxXMeters();
        double bottom = world.ground().minYMeters();
        double top = world.ground().maxYMeters();
        for (Segment wall : world.items(Segment.class)) {
            double beside = crossing(wall.y1Meters(), wall.y2Meters(), y, wall.x1Meters(), wall.x2Meters());
            left = beside < x ? Math.max(left, beside) : left;
            right = beside > x ? Math.min(right, beside) : right;
            double over = crossing(wall.x1Meters(), wall.x2Meters(), x, wall.y1Meters(), wall.y2Meters());
            bottom = over < y ? Math.max(bottom, over) : bottom;
            top = over > y ? Math.min(top, over) : top;
        }
        return new Area(left, bottom, right, top, 0);
    }

    /** The second coordinate of a wall where its first is {@code at}; NaN if it is so nowhere or everywhere. */
    private static double crossing(double from, double to, double at, double secondFrom, double secondTo) {
        boolean crosses = from != to && Math.min(from, to) <= at && at <= Math.max(from, to);
        return crosses ? secondFrom + (at - from) / (to - from) * (secondTo - secondFrom) : Double.NaN;
    }

    static Viewport whole(World world) {
        return Viewport.picture(world.ground(), LONG_SIDE, LEAST_SIDE, MARGIN);
    }

    /** A room's picture, small, so that its names can be read on a phone. */
    static Viewport room(World world, double x, double y) {
        return Viewport.picture(around(world, x, y), ROOM_SIDE, 0, ROOM_MARGIN);
    }

    private static SvgCanvas canvas() {
        return new SvgCanvas(ink -> "var(" + variable(ink) + ")");
    }

    /** The floor, which is the same for all pictures of a world and slow to draw in a large one. */
    static String floor(World world, Viewport view, PlaceNames names) {
        SvgCanvas g = canvas();
        WorldPainter.floor(g, world, view, SHOWN.withNames(names));
        return g.elements();
    }

    /** The robots, and the picture's end. */
    static String robots(SimulationSnapshot scene, Viewport view, PlaceNames names) {
        SvgCanvas g = canvas();
        WorldPainter.movableRobots(g, scene, view, names);
        return g.elements() + "</svg>\n";
    }

    /** The map of a view as a separate file with its colours. */
    static String file(SimulationSnapshot scene, Viewport view, String title, PlaceNames names) {
        String opening = opening(view, title).replaceFirst("<svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"");
        return opening + "<style>:root{" + variables(Appearance.LIGHT) + "}@media(prefers-color-scheme:dark){:root{"
                + variables(Appearance.DARK) + "}}</style>" + floor(scene.world(), view, names)
                + robots(scene, view, names);
    }

    /** The part before the floor. */
    static String opening(Viewport view, String title) {
        String size = SvgCanvas.number(view.width()) + " " + SvgCanvas.number(view.height());
        return "<svg id=\"map\" role=\"img\" viewBox=\"0 0 " + size + "\" data-scale=\""
                + NumberTexts.fixed(view.pixelsPerMeter(), 6) + "\" data-left=\""
                + NumberTexts.fixed(view.worldX(0), 6) + "\" data-top=\"" + NumberTexts.fixed(view.worldY(0), 6)
                + "\" aria-label=\"" + SvgCanvas.escaped(title) + "\">\n";
    }
}
