package simrobot.camera;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/** Colour and depth of each pixel of an image, supersampled to smooth the edges. */
final class PixelBuffer {
    /** Samples per image pixel, horizontally and vertically. */
    static final int FINENESS = 2;

    final int width;
    final int height;
    final int[] rgb;
    final float[] depth;

    /** Creates a buffer for an image of this size, in pixels. */
    PixelBuffer(int pictureWidth, int pictureHeight) {
        width = pictureWidth * FINENESS;
        height = pictureHeight * FINENESS;
        rgb = new int[width * height];
        depth = new float[width * height];
    }

    /** Sets all depths to infinity. */
    void clearDepth() {
        Arrays.fill(depth, Float.POSITIVE_INFINITY);
    }

    /** Sets all pixels to one colour. */
    void fill(int colour) {
        Arrays.fill(rgb, colour);
    }

    /** Sets a pixel unless its depth is smaller. */
    void set(int at, int colour, double meters) {
        if (meters < depth[at]) {
            depth[at] = (float) meters;
            rgb[at] = colour;
        }
    }

    /** Returns the image: each pixel is the mean of its samples. */
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
