package simgsm.gateway.fax;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.sms.GsmAlphabet;

/** Texts that become fax pages. */
class FaxTest {
    private static final ZonedDateTime DATE = ZonedDateTime.of(2026, 11, 28, 9, 5, 59, 0, ZoneOffset.UTC);
    private static final int HEADER_OCTETS = 8;
    private static final int FIELD_OCTETS = 12;

    private static Fax fax(String text) {
        return Fax.of("1.ab", "5550100", "6329", text, DATE);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Hello|6329|Hello",
                "5559999 Hello|5559999|Hello",
                "+34555999900 Hello 1|+34555999900|Hello 1",
                "2026 was good|6329|2026 was good",
                "5559999|6329|5559999",
                "5559999x Hello|6329|5559999x Hello",
                "1234567890123456 Hello|6329|1234567890123456 Hello",
                "**#**20**|6329|**#**20**",
            })
    void aNumberOfAtLeastFiveDigitsInFrontOfTheTextIsTheReceiver(String text, String to, String rest) {
        assertEquals(to, fax(text).to());
        assertEquals(rest, fax(text).text());
    }

    @Test
    void linesBreakAtSpacesAndWithinWordsThatAreLongerThanALine() {
        String word = "0123456789".repeat(9);
        assertEquals(
                List.of(List.of(
                        "a".repeat(79), "bc d", "", word.substring(0, 80), word.substring(80) + " e", "f".repeat(80))),
                fax("a".repeat(79) + " bc d\n\r\n" + word + " e\r" + "f".repeat(80))
                        .pages());
    }

    @Test
    void aTextOfMoreThanAPageAndAFormFeedBeginFurtherPages() {
        List<List<String>> pages = fax("x\n".repeat(FaxPage.LINES) + "y\fz").pages();
        assertEquals(3, pages.size());
        assertEquals(FaxPage.LINES, pages.get(0).size());
        assertEquals(List.of(List.of("y"), List.of("z")), pages.subList(1, 3));
        assertEquals(80, FaxPage.COLUMNS);
    }

    @Test
    void aCharacterBeyondTheFontIsOneReplacementCharacter() {
        assertEquals(List.of(List.of("a\ufffdb")), fax("a\ud83d\ude00b").pages());
        assertArrayEquals(FaxFont.rows('\ufffd'), FaxFont.rows('\u4e2d'));
    }

    @Test
    void eachCharacterOfTheGsmAlphabetHasItsOwnGlyph() {
        byte[] codes = new byte[256];
        for (int code = 0; code < 128; code++) {
            codes[2 * code] = 0x1b;
            codes[2 * code + 1] = (byte) code;
        }
        byte[] plain = new byte[128];
        for (int code = 0; code < 128; code++) {
            plain[code] = (byte) (code == 0x1b ? ' ' : code);
        }
        Map<String, Character> drawn = new TreeMap<>();
        (GsmAlphabet.decode(plain) + GsmAlphabet.decode(codes))
                .chars()
                .filter(c -> c > ' ')
                .forEach(c -> {
                    Character before = drawn.put(Arrays.toString(FaxFont.rows((char) c)), (char) c);
                    assertTrue(before == null || before == c, before + " is drawn as " + (char) c);
                });
        assertFalse(drawn.containsKey(Arrays.toString(FaxFont.rows('\ufffd'))));
        assertFalse(drawn.containsKey(Arrays.toString(FaxFont.rows(' '))));
        assertArrayEquals(FaxFont.rows(' '), FaxFont.rows('\t'));
    }

    @Test
    void thePixelsAreThoseOfTheGlyphsTwiceAsLarge() {
        BufferedImage image = FaxPage.image("A", List.of("", "B"));
        int[] rows = FaxFont.rows('A');
        for (int y = 0; y < 2 * FaxFont.HEIGHT; y++) {
            for (int x = 0; x < 2 * FaxFont.WIDTH; x++) {
                boolean isBlack = (rows[y / 2] >> (9 - x / 2) & 1) == 1;
                assertEquals(isBlack ? 0 : 1, image.getRaster().getSample(64 + x, 64 + y, 0), x + " " + y);
            }
        }
        BufferedImage longLine = FaxPage.image("W".repeat(200), List.of());
        assertEquals(1, longLine.getRaster().getSample(FaxPage.WIDTH - 1, 80, 0));
    }

    @Test
    void theFileIsOneOfTiffFProfileS() throws IOException {
        ByteBuffer file =
                ByteBuffer.wrap(fax("Hello\fWorld").tiff(Arrays::toString)).order(ByteOrder.LITTLE_ENDIAN);
        assertEquals('I' | 'I' << 8 | 42 << 16, file.getInt(0));
        int at = file.getInt(4);
        assertEquals(HEADER_OCTETS, at, "the first directory follows the header");
        for (int page = 0; page < 2; page++) {
            Map<Integer, Integer> values = new TreeMap<>();
            int count = file.getShort(at);
            for (int i = 0; i < count; i++) {
                int field = at + 2 + i * FIELD_OCTETS;
                boolean isShort = file.getShort(field + 2) == 3;
                int value = isShort ? file.getShort(field + HEADER_OCTETS) : file.getInt(field + HEADER_OCTETS);
                boolean isRational = file.getShort(field + 2) == 5;
                values.put((int) file.getShort(field), isRational ? file.getInt(value) : value);
            }
            int offset = values.remove(273);
            int octets = values.remove(279);
            assertTrue(offset > at && offset + octets <= file.limit());
            // RFC 2301, 3.7
            assertEquals(
                    "{254=2, 256=1728, 257=2287, 258=1, 259=3, 262=0, 266=2, 277=1, 278=2287, 282=204, 283=196, 292=0,"
                            + " 296=2, 297=" + page + "}",
                    values.toString());
            // EOL, then a white line: make-up code 1728, terminating code 0; the least significant bit is sent first
            assertEquals(0x2800, file.getShort(offset));
            at = file.getInt(at + 2 + count * FIELD_OCTETS);
        }
        assertEquals(0, at);
    }

    @Test
    void aReaderSeesEachPageWithItsHeader() throws IOException {
        Fax fax = fax("Hello\fWorld");
        ImageReader reader = ImageIO.getImageReadersByFormatName("tiff").next();
        try (ImageInputStream in =
                ImageIO.createImageInputStream(new ByteArrayInputStream(fax.tiff(Arrays::toString)))) {
            reader.setInput(in);
            assertEquals(2, reader.getNumImages(true));
            for (int page = 0; page < 2; page++) {
                String header = "[2026-11-28 09:05, 5550100, 6329, " + (page + 1) + ", 2]";
                BufferedImage drawn = FaxPage.image(header, fax.pages().get(page));
                BufferedImage read = reader.read(page);
                int[] line = new int[FaxPage.WIDTH];
                int[] other = new int[FaxPage.WIDTH];
                for (int y = 0; y < FaxPage.HEIGHT; y++) {
                    assertArrayEquals(
                            drawn.getRGB(0, y, FaxPage.WIDTH, 1, line, 0, FaxPage.WIDTH),
                            read.getRGB(0, y, FaxPage.WIDTH, 1, other, 0, FaxPage.WIDTH),
                            "line " + y);
                }
            }
        }
    }
}
