package simrobot.ui.floor;

import java.awt.AlphaComposite;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import simgsm.draw.Appearance;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.Theme;
import simrobot.drawing.Layers;
import simrobot.drawing.PlaceNames;
import simrobot.drawing.Viewport;
import simrobot.drawing.WorldPainter;
import simrobot.world.World;

/**
 * The floor without its robots as an image in device pixels, painted only after a change of world, viewport, layers or
 * theme: tens of thousands of points take longer to paint than a frame lasts. During a drag of the view the image is
 * shifted, and only the new part is painted.
 */
public final class FloorCache {
    /** The properties that determine the image. */
    private record Key(
            World world,
            Viewport view,
            boolean grid,
            PlaceNames names,
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
                    && key.names == names
                    && key.appearance == appearance
                    && key.zoom == zoom
                    && key.scaleX == scaleX
                    && key.scaleY == scaleY;
        }

        @Override
        public int hashCode() {
            return view.hashCode();
        }

        Key at(Viewport other) {
            return new Key(world, other, grid, names, appearance, zoom, scaleX, scaleY);
        }
    }

    /** Margin around a painted part for the strokes of objects just outside. */
    private static final double REACH_PIXELS = 24;

    private static final double WHOLE = 1e-3;

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
        Key wanted = new Key(
                world,
                view,
                layers.grid(),
                layers.names(),
                Theme.appearance(),
                Theme.zoom(),
                t.getScaleX(),
                t.getScaleY());
        if (!wanted.equals(key)) {
            if (!drag(wanted, layers)) {
                reserve(device, width, height);
                paint(wanted, layers, new Rectangle(width, height));
            }
            key = wanted;
        }
        g.setTransform(
                AffineTransform.getTranslateInstance(Math.rint(t.getTranslateX()), Math.rint(t.getTranslateY())));
        g.drawImage(image, 0, 0, null);
        g.setTransform(t);
        WorldPainter.legend(new GraphicsCanvas(g), view);
    }

    private void reserve(GraphicsConfiguration device, int width, int height) {
        if (image == null || image.getWidth() != width || image.getHeight() != height) {
            image = device.createCompatibleImage(width, height);
        }
    }

    /** Shifts the image, if the wanted view differs from it by whole pixels only; false otherwise. */
    private boolean drag(Key wanted, Layers layers) {
        if (key == null || !key.at(wanted.view).equals(wanted)) {
            return false;
        }
        Viewport before = key.view;
        Viewport after = wanted.view;
        double right = (before.centerX() - after.centerX()) * after.pixelsPerMeter() * wanted.scaleX;
        double down = (after.centerY() - before.centerY()) * after.pixelsPerMeter() * wanted.scaleY;
        int dx = (int) Math.rint(right);
        int dy = (int) Math.rint(down);
        int width = image.getWidth();
        int height = image.getHeight();
        boolean isDragged = before.equals(after.centeredOn(before.centerX(), before.centerY()))
                && Math.abs(right - dx) < WHOLE
                && Math.abs(down - dy) < WHOLE
                && Math.abs(dx) < width
                && Math.abs(dy) < height;
        if (isDragged) {
            Graphics2D g = image.createGraphics();
            g.copyArea(0, 0, width, height, dx, dy);
            g.dispose();
            paint(wanted, layers, new Rectangle(dx > 0 ? 0 : width + dx, 0, Math.abs(dx), height));
            paint(wanted, layers, new Rectangle(0, dy > 0 ? 0 : height + dy, width, Math.abs(dy)));
        }
        return isDragged;
    }

    /** Paints a part of the image. @param part in device pixels */
    private void paint(Key wanted, Layers layers, Rectangle part) {
        if (part.isEmpty()) {
            return;
        }
        double left = part.x / wanted.scaleX - REACH_PIXELS;
        double top = part.y / wanted.scaleY - REACH_PIXELS;
        double width = part.width / wanted.scaleX + 2 * REACH_PIXELS;
        double height = part.height / wanted.scaleY + 2 * REACH_PIXELS;
        Graphics2D g = image.createGraphics();
        try {
            g.setComposite(AlphaComposite.SrcOver);
            g.clip(part);
            g.scale(wanted.scaleX, wanted.scaleY);
            g.translate(left, top);
            WorldPainter.ground(
                    new GraphicsCanvas(g), wanted.world, wanted.view.part(left, top, width, height), layers);
        } finally {
            g.dispose();
        }
    }
}
