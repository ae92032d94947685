package simrobot.bitmap;

import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Reads PNG (ISO/IEC 15948) of every colour type and depth as shades of grey. */
final class PngReader {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    private PngReader() {}

    static boolean isOne(byte[] octets) {
        return octets.length >= SIGNATURE.length && Arrays.equals(octets, 0, 8, SIGNATURE, 0, 8);
    }

    static GrayPicture read(String source, byte[] octets) throws PictureFormatException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("png").next();
        try {
            reader.setInput(new MemoryCacheImageInputStream(new ByteArrayInputStream(octets)), true, true);
            int width = reader.getWidth(0);
            int height = reader.getHeight(0);
            if ((long) width * height > GrayPicture.MOST_PIXELS) {
                throw new PictureFormatException(
                        source,
                        "a picture of " + width + " x " + height + ", expected at most " + GrayPicture.MOST_PIXELS
                                + " pixels");
            }
            return new GrayPicture(width, height, gray(reader.read(0)));
        } catch (PictureFormatException e) {
            throw e;
        } catch (IOException | RuntimeException e) {
            // the JDK's reader throws either for octets that are no PNG
            throw new PictureFormatException(source, "a PNG that cannot be read, expected a whole one");
        } finally {
            reader.dispose();
        }
    }

    private static byte[] gray(BufferedImage picture) {
        int width = picture.getWidth();
        byte[] gray = new byte[width * picture.getHeight()];
        ColorModel colours = picture.getColorModel();
        boolean isGray = colours.getNumColorComponents() == 1 && !(colours instanceof IndexColorModel);
        for (int i = 0; i < gray.length; i++) {
            int x = i % width;
            int y = i / width;
            gray[i] = (byte) (isGray ? shade(picture.getRaster(), colours, x, y) : shade(picture.getRGB(x, y)));
        }
        return gray;
    }

    /** The stored shade, of 8 or 16 bits: getRGB would convert a grey picture to another gamma. */
    private static int shade(Raster raster, ColorModel colours, int x, int y) {
        int more = colours.getComponentSize(0) - 8;
        int shade = raster.getSample(x, y, 0) >> more;
        return colours.hasAlpha() ? onWhite(shade, raster.getSample(x, y, 1) >> more) : shade;
    }

    /** The mean of the three colours, as in map_server. */
    private static int shade(int argb) {
        return onWhite(((argb >> 16 & 0xff) + (argb >> 8 & 0xff) + (argb & 0xff)) / 3, argb >>> 24);
    }

    private static int onWhite(int gray, int alpha) {
        return 255 - (255 - gray) * alpha / 255;
    }
}
