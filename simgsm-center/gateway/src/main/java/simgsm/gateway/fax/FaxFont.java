package simgsm.gateway.fax;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Glyphs of 10 by 20 pixels, so that a page looks the same on each machine and needs no installed font. */
final class FaxFont {
    static final int WIDTH = 10;
    static final int HEIGHT = 20;

    /** Hexadecimal digits of a row, whose 10 leftmost bits are its pixels. */
    private static final int ROW_DIGITS = 3;

    private static final int SPARE_BITS = 4 * ROW_DIGITS - WIDTH;
    private static final int HEX = 16;
    private static final char REPLACEMENT = '\ufffd';
    private static final Map<Character, int[]> GLYPHS = read();

    private FaxFont() {}

    /** Rows from the top; the leftmost pixel is bit 9. Control characters are spaces. */
    static int[] rows(char character) {
        char shown = character < ' ' ? ' ' : character;
        return GLYPHS.getOrDefault(shown, GLYPHS.get(REPLACEMENT));
    }

    /** Lines of the code, a blank and the rows; {@code #} begins a comment. */
    private static Map<Character, int[]> read() {
        try (BufferedReader lines = new BufferedReader(
                new InputStreamReader(FaxFont.class.getResourceAsStream("font.txt"), StandardCharsets.US_ASCII))) {
            return lines.lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(line -> line.split(" "))
                    .collect(Collectors.toMap(
                            words -> (char) Integer.parseInt(words[0], HEX), words -> glyph(words[1])));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static int[] glyph(String digits) {
        return IntStream.range(0, HEIGHT)
                .map(row -> Integer.parseInt(digits, row * ROW_DIGITS, (row + 1) * ROW_DIGITS, HEX) >> SPARE_BITS)
                .toArray();
    }
}
