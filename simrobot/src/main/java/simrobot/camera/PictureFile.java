package simrobot.camera;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Encodes images as PNG or JPEG. */
public final class PictureFile {
    private static final float JPEG_QUALITY = 0.88f;

    private PictureFile() {}

    /** True if the file's ending selects PNG or JPEG. */
    public static boolean hasKnownEnding(Path file) {
        return isPng(file) || endsWith(file, ".jpg") || endsWith(file, ".jpeg");
    }

    /**
     * Writes the image as PNG or JPEG, selected by the file's ending; an existing file is overwritten.
     *
     * @throws IOException if the file cannot be written
     */
    public static void write(BufferedImage picture, Path file) throws IOException {
        Files.write(file, isPng(file) ? png(picture) : jpeg(picture));
    }

    private static boolean isPng(Path file) {
        return endsWith(file, ".png");
    }

    private static boolean endsWith(Path file, String ending) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(ending);
    }

    public static byte[] png(BufferedImage picture) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(octets)) {
            ImageIO.write(picture, "png", out);
        }
        return octets.toByteArray();
    }

    public static byte[] jpeg(BufferedImage picture) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(octets)) {
            ImageWriteParam param = writer.getDefaultWriteParam();
            param.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            param.setCompressionQuality(JPEG_QUALITY);
            writer.setOutput(out);
            writer.write(null, new IIOImage(picture, null, null), param);
        } finally {
            writer.dispose();
        }
        return octets.toByteArray();
    }
}
