package simrobot.bitmap;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import simgsm.octets.Octets;

/** Reads PNG (ISO/IEC 15948) of every colour type and depth, not interlaced, as shades of grey. */
final class PngReader {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    private static final int GRAY = 0;
    private static final int COLOUR = 2;
    private static final int PALETTE = 3;
    private static final int GRAY_ALPHA = 4;
    private static final int COLOUR_ALPHA = 6;

    private final String source;
    private int width;
    private int height;
    private int depth;
    private int type;
    private byte[] palette = {};
    private byte[] transparency = {};
    private final ByteArrayOutputStream deflated = new ByteArrayOutputStream();

    private PngReader(String source) {
        this.source = source;
    }

    static boolean isOne(byte[] octets) {
        return octets.length >= SIGNATURE.length && Arrays.equals(octets, 0, 8, SIGNATURE, 0, 8);
    }

    static GrayPicture read(String source, byte[] octets) throws PictureFormatException {
        PngReader reader = new PngReader(source);
        reader.chunks(ByteBuffer.wrap(octets, 8, octets.length - 8));
        return reader.picture();
    }

    private PictureFormatException broken(String text) {
        return new PictureFormatException(source, text);
    }

    private void chunks(ByteBuffer in) throws PictureFormatException {
        while (in.remaining() >= 12) {
            int length = in.getInt();
            byte[] name = new byte[4];
            in.get(name);
            if (length < 0 || length > in.remaining() - 4) {
                throw broken("the file ends within a part, expected a whole PNG");
            }
            byte[] content = new byte[length];
            in.get(content);
            in.getInt();
            switch (new String(name, StandardCharsets.US_ASCII)) {
                case "IHDR" -> head(content);
                case "PLTE" -> palette = content;
                case "tRNS" -> transparency = content;
                case "IDAT" -> deflated.writeBytes(content);
                default -> {}
            }
        }
    }

    private void head(byte[] content) throws PictureFormatException {
        if (content.length < 13) {
            throw broken("a head of " + content.length + " octets, expected 13");
        }
        ByteBuffer in = ByteBuffer.wrap(content);
        width = in.getInt();
        height = in.getInt();
        depth = in.get();
        type = in.get();
        if (width < 1 || height < 1 || (long) width * height > GrayPicture.MOST_PIXELS) {
            throw broken("a picture of " + width + " x " + height + ", expected at most " + GrayPicture.MOST_PIXELS
                    + " pixels");
        }
        if (content[12] != 0) {
            throw broken("an interlaced PNG, expected one that is not");
        }
    }

    private int channels() throws PictureFormatException {
        return switch (type) {
            case GRAY, PALETTE -> 1;
            case COLOUR -> 3;
            case GRAY_ALPHA -> 2;
            case COLOUR_ALPHA -> 4;
            default -> throw broken("colour type " + type + ", expected 0, 2, 3, 4 or 6");
        };
    }

    private GrayPicture picture() throws PictureFormatException {
        if (width == 0 || depth != 1 && depth != 2 && depth != 4 && depth != 8 && depth != 16) {
            throw broken("no picture, expected a PNG with a head and a depth of 1 to 16 bits");
        }
        int channels = channels();
        int pixelOctets = Math.max(1, channels * depth / 8);
        int rowOctets = (int) (((long) width * channels * depth + 7) / 8);
        byte[] gray = new byte[width * height];
        byte[] before = new byte[rowOctets];
        byte[] row = new byte[rowOctets + 1];
        Inflater inflater = new Inflater();
        inflater.setInput(deflated.toByteArray());
        try {
            for (int y = 0; y < height; y++) {
                fill(inflater, row);
                byte[] now = Octets.range(row, 1, row.length);
                unfilter(row[0], now, before, pixelOctets);
                for (int x = 0; x < width; x++) {
                    gray[y * width + x] = (byte) gray(now, x, channels);
                }
                before = now;
            }
        } catch (DataFormatException e) {
            throw broken("pixels that cannot be inflated, expected a whole PNG");
        } finally {
            inflater.end();
        }
        return new GrayPicture(width, height, gray);
    }

    private void fill(Inflater inflater, byte[] row) throws DataFormatException, PictureFormatException {
        int done = 0;
        while (done < row.length) {
            int size = inflater.inflate(row, done, row.length - done);
            if (size == 0) {
                throw broken("too few pixels, expected " + width + " x " + height);
            }
            done += size;
        }
    }

    /** Clause 9 of the standard. */
    private void unfilter(int filter, byte[] row, byte[] above, int step) throws PictureFormatException {
        if (filter < 0 || filter > 4) {
            throw broken("filter " + filter + ", expected 0 to 4");
        }
        for (int i = 0; i < row.length; i++) {
            int left = i >= step ? row[i - step] & 0xff : 0;
            int up = above[i] & 0xff;
            int corner = i >= step ? above[i - step] & 0xff : 0;
            int predicted = switch (filter) {
                case 1 -> left;
                case 2 -> up;
                case 3 -> (left + up) / 2;
                case 4 -> nearest(left, up, corner);
                default -> 0;
            };
            row[i] += (byte) predicted;
        }
    }

    /** The Paeth predictor. */
    private static int nearest(int left, int up, int corner) {
        int toLeft = Math.abs(up - corner);
        int toUp = Math.abs(left - corner);
        int toCorner = Math.abs(left + up - 2 * corner);
        return toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
    }

    private int sample(byte[] row, int index) {
        if (depth >= 8) {
            return row[index * depth / 8] & 0xff;
        }
        int bit = index * depth;
        return (row[bit / 8] & 0xff) >> (8 - depth - bit % 8) & (1 << depth) - 1;
    }

    private int gray(byte[] row, int x, int channels) {
        int first = sample(row, x * channels);
        if (type == PALETTE) {
            int alpha = first < transparency.length ? transparency[first] & 0xff : 255;
            boolean known = 3 * first + 2 < palette.length;
            return known
                    ? onWhite(luma(palette[3 * first], palette[3 * first + 1], palette[3 * first + 2]), alpha)
                    : 255;
        }
        if (type == GRAY) {
            return depth < 8 ? first * 255 / ((1 << depth) - 1) : first;
        }
        if (type == GRAY_ALPHA) {
            return onWhite(first, sample(row, 2 * x + 1));
        }
        int luma = luma((byte) first, (byte) sample(row, x * channels + 1), (byte) sample(row, x * channels + 2));
        return type == COLOUR ? luma : onWhite(luma, sample(row, 4 * x + 3));
    }

    /** The mean of the three, as map_server takes it. */
    private static int luma(byte red, byte green, byte blue) {
        return ((red & 0xff) + (green & 0xff) + (blue & 0xff)) / 3;
    }

    private static int onWhite(int gray, int alpha) {
        return 255 - (255 - gray) * alpha / 255;
    }
}
