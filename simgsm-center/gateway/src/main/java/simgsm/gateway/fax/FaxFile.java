package simgsm.gateway.fax;

import static javax.imageio.plugins.tiff.BaselineTIFFTagSet.*;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.plugins.tiff.BaselineTIFFTagSet;
import javax.imageio.plugins.tiff.TIFFDirectory;
import javax.imageio.plugins.tiff.TIFFField;
import javax.imageio.plugins.tiff.TIFFTag;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * A file of TIFF-F, profile S (RFC 2301, 3): little-endian, each page one strip of T.4 one-dimensional, the least
 * significant bit first.
 */
final class FaxFile {
    private static final int DOTS_AN_INCH = 204;
    private static final int LINES_AN_INCH = 196;
    /** NewSubfileType: a page of several. */
    private static final int PAGE = 2;

    private final int pages;
    private final ByteArrayOutputStream octets = new ByteArrayOutputStream();
    private final ImageOutputStream stream = new MemoryCacheImageOutputStream(octets);
    private final ImageWriter writer =
            ImageIO.getImageWritersByFormatName("tiff").next();
    private final ImageWriteParam parameters = writer.getDefaultWriteParam();
    private int page;

    FaxFile(int pages) throws IOException {
        this.pages = pages;
        parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        parameters.setCompressionType("CCITT T.4");
        parameters.setTilingMode(ImageWriteParam.MODE_DISABLED);
        IIOMetadata order = writer.getDefaultStreamMetadata(parameters);
        String format = order.getNativeMetadataFormatName();
        IIOMetadataNode root = new IIOMetadataNode(format);
        IIOMetadataNode byteOrder = new IIOMetadataNode("ByteOrder");
        byteOrder.setAttribute("value", "LITTLE_ENDIAN");
        root.appendChild(byteOrder);
        order.setFromTree(format, root);
        writer.setOutput(stream);
        writer.prepareWriteSequence(order);
    }

    void add(BufferedImage image) throws IOException {
        TIFFDirectory directory = TIFFDirectory.createFromMetadata(
                writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(image), parameters));
        addLong(directory, TAG_NEW_SUBFILE_TYPE, PAGE);
        addShorts(directory, TAG_BITS_PER_SAMPLE, 1); // without it SpanDSP refuses the file
        addShorts(directory, TAG_PHOTOMETRIC_INTERPRETATION, PHOTOMETRIC_INTERPRETATION_WHITE_IS_ZERO);
        addShorts(directory, TAG_FILL_ORDER, FILL_ORDER_RIGHT_TO_LEFT);
        addLong(directory, TAG_ROWS_PER_STRIP, image.getHeight());
        addRational(directory, TAG_X_RESOLUTION, DOTS_AN_INCH);
        addRational(directory, TAG_Y_RESOLUTION, LINES_AN_INCH);
        addLong(directory, TAG_T4_OPTIONS, 0); // one-dimensional
        addShorts(directory, TAG_RESOLUTION_UNIT, RESOLUTION_UNIT_INCH);
        addShorts(directory, TAG_PAGE_NUMBER, page++, pages);
        writer.writeToSequence(new IIOImage(image, null, directory.getAsMetadata()), parameters);
    }

    private static void addShorts(TIFFDirectory directory, int tag, int... values) {
        char[] shorts = new char[values.length];
        for (int i = 0; i < values.length; i++) {
            shorts[i] = (char) values[i];
        }
        add(directory, tag, TIFFTag.TIFF_SHORT, shorts.length, shorts);
    }

    private static void addLong(TIFFDirectory directory, int tag, long value) {
        add(directory, tag, TIFFTag.TIFF_LONG, 1, new long[] {value});
    }

    private static void addRational(TIFFDirectory directory, int tag, long value) {
        add(directory, tag, TIFFTag.TIFF_RATIONAL, 1, new long[][] {{value, 1}});
    }

    private static void add(TIFFDirectory directory, int tag, int type, int count, Object value) {
        TIFFTag known = BaselineTIFFTagSet.getInstance().getTag(tag);
        directory.addTIFFField(new TIFFField(known, type, count, value));
    }

    /** The whole file, once all pages are added. */
    byte[] octets() throws IOException {
        writer.endWriteSequence();
        stream.close();
        writer.dispose();
        return octets.toByteArray();
    }
}
