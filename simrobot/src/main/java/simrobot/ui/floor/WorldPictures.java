package simrobot.ui.floor;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageIO;
import simgsm.draw.Appearance;
import simgsm.draw.SvgCanvas;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.Theme;
import simrobot.control.FileExports;
import simrobot.drawing.Layers;
import simrobot.drawing.Viewport;
import simrobot.drawing.WorldPainter;
import simrobot.simulation.SimulationSnapshot;

/**
 * Draws the whole world with its robots and their trails as PNG or SVG, in the window's theme, light or dark, at zoom
 * 1. Callable on any thread.
 */
public final class WorldPictures implements FileExports.Pictures {
    private static final double LONG_SIDE = 1200;
    private static final double LEAST_SIDE = 400;
    private static final double MARGIN = 48;
    /** Scale of PNG: twice the screen's resolution, for print. */
    private static final double PIXELS_PER_UNIT = 2;

    private static final Layers SHOWN = new Layers(true, true, false);

    @Override
    public byte[] of(SimulationSnapshot scene, String selected, String ending) throws IOException {
        Viewport view = Viewport.picture(scene.world().bounds(), LONG_SIDE, LEAST_SIDE, MARGIN);
        return ending.equals("svg") ? svg(scene, view) : png(scene, view);
    }

    private static byte[] png(SimulationSnapshot scene, Viewport view) throws IOException {
        BufferedImage image = new BufferedImage(
                (int) (view.width() * PIXELS_PER_UNIT),
                (int) (view.height() * PIXELS_PER_UNIT),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(PIXELS_PER_UNIT, PIXELS_PER_UNIT);
        WorldPainter.paint(new GraphicsCanvas(g, Theme.appearance(), 1), scene, view, SHOWN, null);
        g.dispose();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }

    private static byte[] svg(SimulationSnapshot scene, Viewport view) {
        Appearance appearance = Theme.appearance();
        SvgCanvas canvas = new SvgCanvas(ink -> ink.hex(appearance));
        WorldPainter.paint(canvas, scene, view, SHOWN, null);
        return canvas.document(view.width(), view.height(), scene.world().name())
                .getBytes(StandardCharsets.UTF_8);
    }
}
