package simgsm.sms;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

class CellBroadcastTest {
    private static final BroadcastSerial SERIAL = new BroadcastSerial(1, 1, 1);
    private static final int CHANNEL = 50;

    @Test
    void aPageIs88OctetsFilledWithCarriageReturns() {
        List<CellBroadcastPage> pages = CellBroadcast.split("Welcome", CHANNEL, SERIAL, Optional.empty());

        assertEquals(1, pages.size());
        String hex = pages.get(0).encode().toString();
        assertEquals(2 * CellBroadcastPage.LENGTH, hex.length());
        assertEquals("401100320f11" + "d7327bfc6e971b", hex.substring(0, 26));
    }

    @ParameterizedTest
    @CsvSource({"en, 0x01", "es, 0x04", "cs, 0x20", "xx, 0x10"})
    void aLanguageChoosesTheCoding(String language, String coding) {
        CellBroadcastPage page = CellBroadcast.split("Hola", CHANNEL, SERIAL, Optional.of(language))
                .get(0);

        assertEquals(Integer.decode(coding), page.coding().octet());
        assertEquals(
                new CellBroadcast(CHANNEL, SERIAL, Optional.of(language), 1, "Hola"),
                CellBroadcast.join(List.of(page)));
    }

    @Test
    void ucs2CarriesTheLanguageInFront() {
        CellBroadcastPage page = CellBroadcast.split("Atención", CHANNEL, SERIAL, Optional.of("es"))
                .get(0);

        assertEquals(0x11, page.coding().octet());
        assertEquals("e5390041", page.content().toString().substring(0, 8));
        assertEquals(
                new CellBroadcast(CHANNEL, SERIAL, Optional.of("es"), 1, "Atención"),
                CellBroadcast.join(List.of(page)));
    }

    @ParameterizedTest
    @CsvSource({
        "a, 93, 1",
        "a, 94, 2",
        "a, 1395, 15",
        "€, 46, 1",
        "€, 47, 2",
        "á, 41, 1",
        "á, 42, 2",
        "á, 615, 15",
        "🤖, 20, 1",
        "🤖, 21, 2"
    })
    void pagesHold93SeptetsOr41Characters(String symbol, int count, int pages) {
        assertEquals(
                pages,
                CellBroadcast.split(symbol.repeat(count), CHANNEL, SERIAL, Optional.empty())
                        .size());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "Aviso: el robot se mueve.\nFin.", "€uro {x} [y]", "Señal á 移动 🤖"})
    void textComesBackUnharmed(String text) {
        for (String language : new String[] {"", "es", "xx"}) {
            for (int times : new int[] {1, 13}) {
                String longText = text.repeat(times);
                List<CellBroadcastPage> pages = CellBroadcast.split(
                        longText, CHANNEL, SERIAL, Optional.of(language).filter(each -> !each.isEmpty()));

                assertEquals(longText, CellBroadcast.join(pages).text());
            }
        }
    }

    @Test
    void lineEndsBecomeLineFeedsBecauseCarriageReturnsFill() {
        List<CellBroadcastPage> pages = CellBroadcast.split("a\r\nb\rc\r", CHANNEL, SERIAL, Optional.empty());

        assertEquals("a\nb\nc\n", CellBroadcast.join(pages).text());
    }

    @Test
    void moreThanFifteenPagesAreRefused() {
        String text = "a".repeat(1396);
        IllegalArgumentException refusal = assertThrows(
                IllegalArgumentException.class, () -> CellBroadcast.split(text, CHANNEL, SERIAL, Optional.empty()));

        assertTrue(refusal.getMessage().contains("16"), refusal.getMessage());
    }

    @Test
    void nonsenseIsNoBroadcast() {
        assertThrows(IllegalArgumentException.class, () -> CellBroadcast.split("a", 65536, SERIAL, Optional.empty()));
        assertThrows(IllegalArgumentException.class, () -> CellBroadcast.split("a", 1, SERIAL, Optional.of("english")));
        assertThrows(IllegalArgumentException.class, () -> new BroadcastSerial(4, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> new BroadcastSerial(0, 1024, 0));
        assertThrows(IllegalArgumentException.class, () -> new BroadcastSerial(0, 0, 16));
    }

    @Test
    void aPageIsReadBack() throws ProtocolViolation {
        for (CellBroadcastPage page : CellBroadcast.split("a".repeat(200), 4370, SERIAL, Optional.of("en"))) {
            assertEquals(page, CellBroadcastPage.decode(page.encode()));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"00", "21", "01", "30"})
    void pageNumbersWithoutSenseCountAsTheOnlyPage(String numbers) throws ProtocolViolation {
        OctetString octets = OctetString.ofHex("401100320f" + numbers + "0d".repeat(82));

        CellBroadcastPage page = CellBroadcastPage.decode(octets);

        assertEquals(1, page.page());
        assertEquals(1, page.pages());
    }

    @Test
    void aPageOfAnotherLengthIsRefused() {
        assertThrows(
                ProtocolViolation.class,
                () -> CellBroadcastPage.decode(OctetString.ofHex("401100320f11" + "0d".repeat(81))));
    }

    @Test
    void everyCodingGivesText() throws ProtocolViolation {
        Random random = new Random(23041);
        for (int coding = 0; coding < 256; coding++) {
            byte[] octets = new byte[CellBroadcastPage.LENGTH];
            random.nextBytes(octets);
            octets[4] = (byte) coding;
            CellBroadcastPage page = CellBroadcastPage.decode(OctetString.of(octets));

            assertEquals(
                    coding, CellBroadcastPage.decode(page.encode()).coding().octet());
            assertTrue(CellBroadcast.join(List.of(page)).text().length() <= 2 * CellBroadcastPage.CONTENT_LENGTH);
        }
    }

    @Test
    void pagesInAnyOrderMakeTheMessageOnce() {
        BroadcastCollector collector = new BroadcastCollector();
        String text = "Evacúen el laboratorio. ".repeat(10);
        List<CellBroadcastPage> pages = new ArrayList<>(CellBroadcast.split(text, CHANNEL, SERIAL, Optional.empty()));
        Collections.shuffle(pages, new Random(1));
        List<CellBroadcast> shown = new ArrayList<>();
        for (int repetition = 0; repetition < 3; repetition++) {
            pages.forEach(page -> collector.accept(page).ifPresent(shown::add));
        }

        assertEquals(List.of(new CellBroadcast(CHANNEL, SERIAL, Optional.empty(), pages.size(), text)), shown);
    }

    @Test
    void anUpdateIsANewMessage() {
        BroadcastCollector collector = new BroadcastCollector();
        CellBroadcastPage first =
                CellBroadcast.split("a", CHANNEL, SERIAL, Optional.empty()).get(0);
        CellBroadcastPage update = CellBroadcast.split("b", CHANNEL, new BroadcastSerial(1, 1, 2), Optional.empty())
                .get(0);

        assertTrue(collector.accept(first).isPresent());
        assertTrue(collector.accept(first).isEmpty());
        assertTrue(collector.accept(update).isPresent());
    }

    @Test
    void theCollectorsMemoryIsBounded() {
        BroadcastCollector collector = new BroadcastCollector();
        CellBroadcastPage first =
                CellBroadcast.split("a", 0, SERIAL, Optional.empty()).get(0);
        assertTrue(collector.accept(first).isPresent());
        for (int channel = 1; channel <= BroadcastCollector.MAX_MESSAGES; channel++) {
            collector.accept(
                    CellBroadcast.split("a", channel, SERIAL, Optional.empty()).get(0));
        }

        assertTrue(collector.accept(first).isPresent(), "the oldest has been forgotten");
    }
}
