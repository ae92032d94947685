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
import simrobot.world.World;

/**
 * The page's map: the window's picture of the floor as SVG, with a group for each robot that the page's script moves.
 * Its colours are variables of the page's style sheet.
 */
final class WorldMap {
    private static final double LONG_SIDE = 960;
    private static final double LEAST_SIDE = 200;
    private static final double MARGIN = 48;
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

    private static Viewport view(World world) {
        return Viewport.picture(world.ground(), LONG_SIDE, LEAST_SIDE, MARGIN);
    }

    private static SvgCanvas canvas() {
        return new SvgCanvas(ink -> "var(" + variable(ink) + ")");
    }

    /** The floor, which is the same for all pictures of a world and slow to draw in a large one. */
    static String floor(World world, PlaceNames names) {
        SvgCanvas g = canvas();
        WorldPainter.floor(g, world, view(world), SHOWN.withNames(names));
        return g.elements();
    }

    /** The robots, and the picture's end. */
    static String robots(SimulationSnapshot scene, PlaceNames names) {
        SvgCanvas g = canvas();
        WorldPainter.movableRobots(g, scene, view(scene.world()), names);
        return g.elements() + "</svg>\n";
    }

    /** The whole map as a separate file with its colours. */
    static String file(SimulationSnapshot scene, String title, PlaceNames names) {
        String opening =
                opening(scene.world(), title).replaceFirst("<svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"");
        return opening + "<style>:root{" + variables(Appearance.LIGHT) + "}@media(prefers-color-scheme:dark){:root{"
                + variables(Appearance.DARK) + "}}</style>" + floor(scene.world(), names) + robots(scene, names);
    }

    /** The part before the floor. */
    static String opening(World world, String title) {
        Viewport view = view(world);
        String size = SvgCanvas.number(view.width()) + " " + SvgCanvas.number(view.height());
        return "<svg id=\"map\" role=\"img\" viewBox=\"0 0 " + size + "\" data-scale=\""
                + NumberTexts.fixed(view.pixelsPerMeter(), 6) + "\" data-left=\""
                + NumberTexts.fixed(view.worldX(0), 6) + "\" data-top=\"" + NumberTexts.fixed(view.worldY(0), 6)
                + "\" aria-label=\"" + SvgCanvas.escaped(title) + "\">\n";
    }
}
