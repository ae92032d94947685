package simrobot.ui.floor;

import java.awt.AlphaComposite;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import simgsm.draw.Appearance;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.Theme;
import simrobot.drawing.Layers;
import simrobot.drawing.Viewport;
import simrobot.drawing.WorldPainter;
import simrobot.world.World;

/**
 * The floor without its robots as an image in device pixels, painted again only when world, viewport, layers or theme
 * change: a floor of tens of thousands of points takes longer to paint than a frame lasts.
 */
public final class FloorCache {
    /** All that the image depends on. */
    private record Key(
            World world,
            Viewport view,
            boolean grid,
            Appearance appearance,
            double zoom,
            double scaleX,
            double scaleY) {
        @Override
        public boolean equals(Object other) {
            // worlds are compared by identity: comparing points would cost what the image saves
            return other instanceof Key key
                    && key.world == world
                    && key.view.equals(view)
                    && key.grid == grid
                    && key.appearance == appearance
                    && key.zoom == zoom
                    && key.scaleX == scaleX
                    && key.scaleY == scaleY;
        }

        @Override
        public int hashCode() {
            return view.hashCode();
        }
    }

    private Key key;
    private BufferedImage image;

    /** Draws the floor, from the image unless the device cannot hold one. */
    public void paint(Graphics2D g, World world, Viewport view, Layers layers) {
        AffineTransform t = g.getTransform();
        GraphicsConfiguration device = g.getDeviceConfiguration();
        int width = (int) Math.ceil(view.width() * t.getScaleX());
        int height = (int) Math.ceil(view.height() * t.getScaleY());
        if (device == null || t.getShearX() != 0 || t.getShearY() != 0 || width < 1 || height < 1) {
            WorldPainter.floor(new GraphicsCanvas(g), world, view, layers);
            return;
        }
        Key wanted =
                new Key(world, view, layers.grid(), Theme.appearance(), Theme.zoom(), t.getScaleX(), t.getScaleY());
        if (!wanted.equals(key)) {
            picture(device, width, height, t, world, view, layers);
            key = wanted;
        }
        g.setTransform(
                AffineTransform.getTranslateInstance(Math.rint(t.getTranslateX()), Math.rint(t.getTranslateY())));
        g.drawImage(image, 0, 0, null);
        g.setTransform(t);
    }

    private void picture(
            GraphicsConfiguration device,
            int width,
            int height,
            AffineTransform t,
            World world,
            Viewport view,
            Layers layers) {
        if (image == null || image.getWidth() != width || image.getHeight() != height) {
            image = device.createCompatibleImage(width, height);
        }
        Graphics2D g = image.createGraphics();
        try {
            g.setComposite(AlphaComposite.SrcOver);
            g.scale(t.getScaleX(), t.getScaleY());
            WorldPainter.floor(new GraphicsCanvas(g), world, view, layers);
        } finally {
            g.dispose();
        }
    }
}
