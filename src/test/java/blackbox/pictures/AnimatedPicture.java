package blackbox.pictures;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOInvalidTreeException;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

/**
 * Pictures of one size as an animated GIF. All share 255 colours, the most frequent ones; each picture after the first holds
 * only the rectangle that has changed, and in it only the changed pixels.
 */
final class AnimatedPicture {
    private static final int COLORS = 255;
    private static final int TRANSPARENT = COLORS;
    private static final String FORMAT = "javax_imageio_gif_image_1.0";
    private static final String STREAM_FORMAT = "javax_imageio_gif_stream_1.0";

    private final List<int[]> pictures = new ArrayList<>();
    private final List<Integer> hundredths = new ArrayList<>();
    private final int width;
    private final int height;

    AnimatedPicture(int width, int height) {
        this.width = width;
        this.height = height;
    }

    /** Adds a picture and the time that it is shown. The same picture again adds to that time. */
    void add(BufferedImage image, double seconds) {
        int[] pixels = image.getRGB(0, 0, width, height, null, 0, width);
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] &= 0xFFFFFF;
        }
        int time = (int) Math.round(seconds * 100);
        int last = pictures.size() - 1;
        if (last >= 0 && Arrays.equals(pictures.get(last), pixels)) {
            hundredths.set(last, hundredths.get(last) + time);
        } else {
            pictures.add(pixels);
            hundredths.add(time);
        }
    }

    void write(Path file) throws IOException {
        int[] palette = palette();
        Map<Integer, Integer> nearest = new HashMap<>();
        IndexColorModel colors = model(palette);
        ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
        Files.deleteIfExists(file);
        try (ImageOutputStream out = ImageIO.createImageOutputStream(file.toFile())) {
            writer.setOutput(out);
            writer.prepareWriteSequence(streamMetadata(writer, palette));
            int[] shown = null;
            for (int i = 0; i < pictures.size(); i++) {
                int[] next = indices(pictures.get(i), palette, nearest);
                Rectangle changed = changed(shown, next);
                BufferedImage image =
                        new BufferedImage(changed.width, changed.height, BufferedImage.TYPE_BYTE_INDEXED, colors);
                for (int y = 0; y < changed.height; y++) {
                    for (int x = 0; x < changed.width; x++) {
                        int at = (changed.y + y) * width + changed.x + x;
                        boolean same = shown != null && shown[at] == next[at];
                        image.getRaster().setSample(x, y, 0, same ? TRANSPARENT : next[at]);
                    }
                }
                writer.writeToSequence(new IIOImage(image, null, metadata(writer, image, changed, i)), null);
                shown = next;
            }
            writer.endWriteSequence();
        } finally {
            writer.dispose();
        }
    }

    /** The most frequent colours of all pictures. */
    private int[] palette() {
        Map<Integer, Integer> counts = new HashMap<>();
        for (int[] pixels : pictures) {
            for (int pixel : pixels) {
                counts.merge(pixel, 1, Integer::sum);
            }
        }
        return counts.entrySet().stream()
                .sorted(Map.Entry.<Integer, Integer>comparingByValue()
                        .reversed()
                        .thenComparing(Map.Entry.comparingByKey()))
                .limit(COLORS)
                .mapToInt(Map.Entry::getKey)
                .toArray();
    }

    private static IndexColorModel model(int[] palette) {
        byte[] red = new byte[COLORS + 1];
        byte[] green = new byte[COLORS + 1];
        byte[] blue = new byte[COLORS + 1];
        for (int i = 0; i < palette.length; i++) {
            red[i] = (byte) (palette[i] >> 16);
            green[i] = (byte) (palette[i] >> 8);
            blue[i] = (byte) palette[i];
        }
        return new IndexColorModel(8, COLORS + 1, red, green, blue, TRANSPARENT);
    }

    /** The size and the colours of all pictures. */
    private IIOMetadata streamMetadata(ImageWriter writer, int... palette) throws IIOInvalidTreeException {
        IIOMetadata metadata = writer.getDefaultStreamMetadata(null);
        IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(STREAM_FORMAT);
        IIOMetadataNode screen = child(root, "LogicalScreenDescriptor");
        screen.setAttribute("logicalScreenWidth", String.valueOf(width));
        screen.setAttribute("logicalScreenHeight", String.valueOf(height));
        screen.setAttribute("colorResolution", "8");
        screen.setAttribute("pixelAspectRatio", "0");
        IIOMetadataNode table = new IIOMetadataNode("GlobalColorTable");
        table.setAttribute("sizeOfGlobalColorTable", String.valueOf(COLORS + 1));
        table.setAttribute("backgroundColorIndex", "0");
        table.setAttribute("sortFlag", "FALSE");
        for (int i = 0; i <= COLORS; i++) {
            int color = i < palette.length ? palette[i] : 0;
            IIOMetadataNode entry = new IIOMetadataNode("ColorTableEntry");
            entry.setAttribute("index", String.valueOf(i));
            entry.setAttribute("red", String.valueOf(color >> 16 & 0xFF));
            entry.setAttribute("green", String.valueOf(color >> 8 & 0xFF));
            entry.setAttribute("blue", String.valueOf(color & 0xFF));
            table.appendChild(entry);
        }
        root.appendChild(table);
        metadata.setFromTree(STREAM_FORMAT, root);
        return metadata;
    }

    private static int[] indices(int[] pixels, int[] palette, Map<Integer, Integer> nearest) {
        int[] indices = new int[pixels.length];
        for (int i = 0; i < pixels.length; i++) {
            indices[i] = nearest.computeIfAbsent(pixels[i], color -> nearest(color, palette));
        }
        return indices;
    }

    private static int nearest(int color, int[] palette) {
        int best = 0;
        long least = Long.MAX_VALUE;
        for (int i = 0; i < palette.length; i++) {
            long red = (color >> 16 & 0xFF) - (palette[i] >> 16 & 0xFF);
            long green = (color >> 8 & 0xFF) - (palette[i] >> 8 & 0xFF);
            long blue = (color & 0xFF) - (palette[i] & 0xFF);
            long distance = 2 * red * red + 4 * green * green + 3 * blue * blue;
            if (distance < least) {
                least = distance;
                best = i;
            }
        }
        return best;
    }

    private Rectangle changed(int[] before, int[] now) {
        Rectangle all = new Rectangle(width, height);
        if (before == null) {
            return all;
        }
        Rectangle changed = null;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                if (before[y * width + x] != now[y * width + x]) {
                    Rectangle pixel = new Rectangle(x, y, 1, 1);
                    changed = changed == null ? pixel : changed.union(pixel);
                }
            }
        }
        return changed == null ? new Rectangle(1, 1) : changed;
    }

    private IIOMetadata metadata(ImageWriter writer, BufferedImage image, Rectangle place, int index)
            throws IIOInvalidTreeException {
        IIOMetadata metadata = writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(image), null);
        IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(FORMAT);
        // All pictures have the colours of the file.
        root.removeChild(child(root, "LocalColorTable"));
        IIOMetadataNode descriptor = child(root, "ImageDescriptor");
        descriptor.setAttribute("imageLeftPosition", String.valueOf(place.x));
        descriptor.setAttribute("imageTopPosition", String.valueOf(place.y));
        IIOMetadataNode control = child(root, "GraphicControlExtension");
        control.setAttribute("disposalMethod", "doNotDispose");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", "TRUE");
        control.setAttribute("transparentColorIndex", String.valueOf(TRANSPARENT));
        control.setAttribute("delayTime", String.valueOf(hundredths.get(index)));
        if (index == 0) {
            // The application extension of Netscape repeats the pictures for ever.
            IIOMetadataNode loop = new IIOMetadataNode("ApplicationExtension");
            loop.setAttribute("applicationID", "NETSCAPE");
            loop.setAttribute("authenticationCode", "2.0");
            loop.setUserObject(new byte[] {1, 0, 0});
            child(root, "ApplicationExtensions").appendChild(loop);
        }
        metadata.setFromTree(FORMAT, root);
        return metadata;
    }

    private static IIOMetadataNode child(IIOMetadataNode root, String name) {
        for (int i = 0; i < root.getLength(); i++) {
            if (root.item(i).getNodeName().equals(name)) {
                return (IIOMetadataNode) root.item(i);
            }
        }
        IIOMetadataNode made = new IIOMetadataNode(name);
        root.appendChild(made);
        return made;
    }
}
