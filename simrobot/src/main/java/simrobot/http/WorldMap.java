package simrobot.http;

import java.util.Locale;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.draw.SvgCanvas;
import simrobot.drawing.Layers;
import simrobot.drawing.NumberTexts;
import simrobot.drawing.Viewport;
import simrobot.drawing.WorldPainter;
import simrobot.simulation.SimulationSnapshot;

/**
 * The page's map: the window's picture of the floor as SVG, with a group for each robot that the page's script moves. Its
 * colours are variables of the page's style sheet.
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

    static String svg(SimulationSnapshot scene, String title) {
        Viewport view = Viewport.picture(scene.world().ground(), LONG_SIDE, LEAST_SIDE, MARGIN);
        SvgCanvas g = new SvgCanvas(ink -> "var(" + variable(ink) + ")");
        WorldPainter.floor(g, scene.world(), view, SHOWN);
        WorldPainter.movableRobots(g, scene, view);
        String size = SvgCanvas.number(view.width()) + " " + SvgCanvas.number(view.height());
        return "<svg id=\"map\" role=\"img\" viewBox=\"0 0 " + size + "\" data-scale=\""
                + NumberTexts.fixed(view.pixelsPerMeter(), 6) + "\" data-left=\""
                + NumberTexts.fixed(view.worldX(0), 6) + "\" data-top=\"" + NumberTexts.fixed(view.worldY(0), 6)
                + "\" aria-label=\"" + SvgCanvas.escaped(title) + "\">\n" + g.elements() + "</svg>\n";
    }
}
