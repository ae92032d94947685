package simrobot.camera;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/** A picture under way: a colour and a depth for each pixel. Drawn finer than it is shown, so that edges are smooth. */
final class PixelBuffer {
    /** Pixels across and down for one of the picture. */
    static final int FINENESS = 2;

    final int width;
    final int height;
    final int[] rgb;
    final float[] depth;

    /** For a picture of this size. */
    PixelBuffer(int pictureWidth, int pictureHeight) {
        width = pictureWidth * FINENESS;
        height = pictureHeight * FINENESS;
        rgb = new int[width * height];
        depth = new float[width * height];
    }

    /** Nothing stands anywhere. */
    void clearDepth() {
        Arrays.fill(depth, Float.POSITIVE_INFINITY);
    }

    /** One colour everywhere. */
    void fill(int colour) {
        Arrays.fill(rgb, colour);
    }

    /** Sets a pixel unless something nearer is there. */
    void set(int at, int colour, double meters) {
        if (meters < depth[at]) {
            depth[at] = (float) meters;
            rgb[at] = colour;
        }
    }

    /** The mean of each square of fine pixels. */
    BufferedImage picture() {
        BufferedImage picture = new BufferedImage(width / FINENESS, height / FINENESS, BufferedImage.TYPE_INT_RGB);
        int[] out = ((DataBufferInt) picture.getRaster().getDataBuffer()).getData();
        int to = 0;
        for (int row = 0; row < height; row += FINENESS) {
            for (int column = 0; column < width; column += FINENESS) {
                out[to++] = mean(row * width + column);
            }
        }
        return picture;
    }

    private int mean(int at) {
        int a = rgb[at];
        int b = rgb[at + 1];
        int c = rgb[at + width];
        int d = rgb[at + width + 1];
        int redBlue = ((a & 0xFF00FF) + (b & 0xFF00FF) + (c & 0xFF00FF) + (d & 0xFF00FF)) >>> 2 & 0xFF00FF;
        int green = ((a & 0x00FF00) + (b & 0x00FF00) + (c & 0x00FF00) + (d & 0x00FF00)) >>> 2 & 0x00FF00;
        return redBlue | green;
    }
}
