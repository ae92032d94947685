package simgsm.ui;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import javax.swing.JComponent;
import simgsm.draw.Ink;

/** Paints components into pictures without a display, and counts colours in them. */
public final class Painted {
    private Painted() {}

    public static BufferedImage at(JComponent component, double scale) {
        component.setSize(component.getPreferredSize());
        return at(component, component.getWidth(), component.getHeight(), scale);
    }

    public static BufferedImage at(JComponent component, int width, int height, double scale) {
        component.setSize(width, height);
        component.doLayout();
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(width * scale), (int) Math.ceil(height * scale), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(Theme.color(Ink.CARD));
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        g.scale(scale, scale);
        component.paint(g);
        g.dispose();
        return image;
    }

    public static int count(BufferedImage image, Ink ink) {
        int count = 0;
        for (int rgb : image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth())) {
            count += rgb == Theme.color(ink).getRGB() ? 1 : 0;
        }
        return count;
    }

    public static int hash(BufferedImage image) {
        return java.util.Arrays.hashCode(
                image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()));
    }
}
