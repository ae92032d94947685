package simgsm.ui.window;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Symbol;

/** The icon of a window in the sizes that desktops use: a symbol on a square in the accent colour. */
public final class WindowIcon {
    private static final int[] SIZES = {16, 24, 32, 48, 64, 128};

    private WindowIcon() {}

    public static List<Image> images(Symbol symbol) {
        List<Image> images = new ArrayList<>();
        for (int size : SIZES) {
            images.add(image(symbol, size));
        }
        return images;
    }

    /** @param size of a side, in pixels */
    public static BufferedImage image(Symbol symbol, int size) {
        BufferedImage image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = Drawing.on(image.createGraphics());
        g.setColor(new Color(Ink.ACCENT.rgb(Appearance.LIGHT)));
        g.fill(Drawing.round(0, 0, size, size, size * 0.22));
        g.setColor(new Color(Ink.ON_ACCENT.rgb(Appearance.LIGHT)));
        symbol.paint(g, size / 2.0, size / 2.0, size * 0.78);
        g.dispose();
        return image;
    }
}
