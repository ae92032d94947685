package simgsm.gateway.fax;

import java.awt.image.BufferedImage;
import java.awt.image.WritableRaster;
import java.util.Arrays;
import java.util.List;

/** Draws the pixels of one page: A4 of a Group 3 machine at 204 by 196 dots an inch. */
final class FaxPage {
    /** Pixels of a line (ITU-T T.4, 2.2). */
    static final int WIDTH = 1728;
    /** Lines of 297 mm at 7.7 lines a millimetre. */
    static final int HEIGHT = 2287;
    /** A glyph's pixel is drawn 2 by 2: a character is 2.5 mm wide. */
    private static final int SCALE = 2;

    private static final int MARGIN = 64;
    private static final int COLUMN = SCALE * FaxFont.WIDTH;
    private static final int LINE = SCALE * FaxFont.HEIGHT;
    private static final int TEXT_TOP = MARGIN + 2 * LINE;

    static final int COLUMNS = (WIDTH - 2 * MARGIN) / COLUMN;
    static final int LINES = (HEIGHT - TEXT_TOP - MARGIN) / LINE;

    private FaxPage() {}

    /** A page of at most {@link #LINES} lines of {@link #COLUMNS} characters; of 1 bit a pixel, 0 is black. */
    static BufferedImage image(String header, List<String> lines) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_BYTE_BINARY);
        WritableRaster raster = image.getRaster();
        int[] white = new int[WIDTH];
        Arrays.fill(white, 1);
        for (int y = 0; y < HEIGHT; y++) {
            raster.setSamples(0, y, WIDTH, 1, 0, white);
        }
        draw(raster, header, MARGIN);
        for (int i = 0; i < lines.size(); i++) {
            draw(raster, lines.get(i), TEXT_TOP + i * LINE);
        }
        return image;
    }

    private static void draw(WritableRaster raster, String line, int top) {
        for (int column = 0; column < Math.min(line.length(), COLUMNS); column++) {
            int[] rows = FaxFont.rows(line.charAt(column));
            for (int i = 0; i < LINE * COLUMN; i++) {
                int x = i % COLUMN;
                int y = i / COLUMN;
                if ((rows[y / SCALE] >> (FaxFont.WIDTH - 1 - x / SCALE) & 1) == 1) {
                    raster.setSample(MARGIN + column * COLUMN + x, top + y, 0, 0);
                }
            }
        }
    }
}
