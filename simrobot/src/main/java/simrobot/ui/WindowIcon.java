package simrobot.ui;

import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Stream;
import simgsm.ui.Drawing;
import simgsm.ui.Theme.Ink;

/** The robot seen from above, for the window's corner and the task bar. */
public final class WindowIcon {
    private WindowIcon() {}

    public static List<Image> images() {
        return Stream.of(16, 32, 64, 128).map(WindowIcon::image).toList();
    }

    private static Image image(int side) {
        BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = image.createGraphics();
        try {
            Drawing.prepare(g);
            g.translate(side / 2.0, side * 0.42);
            g.rotate(-Math.PI / 2);
            g.scale(side * 2.1, -side * 2.1);
            RobotPainter.emblem(g, Ink.ROBOT);
        } finally {
            g.dispose();
        }
        return image;
    }
}
