package simrobot.ui.floor;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageIO;
import simrobot.control.FileExports;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Area;

/** The whole world with its robots and their trails as a picture: PNG in pixels, SVG in lines. By the window's painters. */
public final class WorldPictures implements FileExports.Pictures {
    private static final double LONG_SIDE = 1200;
    private static final double LEAST_SIDE = 400;
    private static final double MARGIN = 48;
    /** Of a PNG, so that it can be printed. */
    private static final double PIXELS_PER_UNIT = 2;

    private static final Layers SHOWN = new Layers(true, true, false);

    @Override
    public byte[] of(SimulationSnapshot scene, String selected, String ending) throws IOException {
        Viewport view = view(scene);
        return ending.equals("svg") ? svg(scene, view) : png(scene, view);
    }

    /** As high as the world asks for. */
    private static Viewport view(SimulationSnapshot scene) {
        Area bounds = scene.world().bounds();
        double wide = Math.max(1, bounds.maxXMeters() - bounds.minXMeters());
        double high = Math.max(1, bounds.maxYMeters() - bounds.minYMeters());
        double scale = (LONG_SIDE - 2 * MARGIN) / Math.max(wide, high);
        double width = Math.rint(Math.max(LEAST_SIDE, wide * scale + 2 * MARGIN));
        double height = Math.rint(Math.max(LEAST_SIDE, high * scale + 2 * MARGIN));
        return Viewport.fitting(bounds, width, height, MARGIN);
    }

    private static byte[] png(SimulationSnapshot scene, Viewport view) throws IOException {
        BufferedImage image = new BufferedImage(
                (int) (view.width() * PIXELS_PER_UNIT),
                (int) (view.height() * PIXELS_PER_UNIT),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(PIXELS_PER_UNIT, PIXELS_PER_UNIT);
        WorldPainter.paint(g, scene, view, SHOWN, null);
        g.dispose();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }

    private static byte[] svg(SimulationSnapshot scene, Viewport view) {
        SvgCanvas canvas =
                new SvgCanvas(view.width(), view.height(), scene.world().name());
        WorldPainter.paint(canvas, scene, view, SHOWN, null);
        return canvas.document().getBytes(StandardCharsets.UTF_8);
    }
}
