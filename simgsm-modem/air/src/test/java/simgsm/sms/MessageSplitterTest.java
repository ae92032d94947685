package simgsm.sms;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.octets.OctetString;

class MessageSplitterTest {
    @Test
    void helloIsPackedAsInTheStandard() {
        assertEquals(
                new UserData(false, DataCodingScheme.GSM_7BIT, 5, OctetString.ofHex("e8329bfd06")),
                UserData.of("hello"));
    }

    @Test
    void aHeaderIsFollowedByFillBitsUpToTheNextSeptet() {
        UserData first = MessageSplitter.split("a".repeat(161), 0x2a).get(0);

        assertTrue(first.hasHeader());
        assertEquals(160, first.length());
        assertEquals(140, first.octets().length());
        assertEquals("0500032a0201c2e1", first.octets().toString().substring(0, 16));
        assertEquals(Optional.of(new Concatenation(0x2a, 2, 1)), first.concatenation());
        assertEquals("a".repeat(153), first.text());
    }

    @ParameterizedTest
    @CsvSource({
        "a,0,1,160",
        "a,1,1,159",
        "a,160,1,0",
        "a,161,2,145",
        "a,306,2,0",
        "a,307,3,152",
        "a,39015,255,0",
        "a,39016,256,152",
        "á,70,1,0",
        "á,71,2,63",
        "á,134,2,0",
        "á,135,3,66",
        "á,17085,255,0",
        "á,17086,256,66",
        "€,80,1,0",
        "€,81,2,143",
        "🤖,35,1,0",
        "🤖,36,2,61"
    })
    void theMeasureCountsUnitsAndParts(String symbol, int count, int parts, int unitsLeft) {
        MessageSplitter.Measure measure = MessageSplitter.measure(symbol.repeat(count));

        assertEquals(parts, measure.parts());
        assertEquals(unitsLeft, measure.unitsLeft());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "hello",
                "** #**20 **",
                "Señal: ¿ñandú? €{}[]~\\|^",
                "robot 移动 двадцать ευρώ",
                "🤖🧭",
                "@@@@@@@",
                "a\nb\rc\fd",
                "\ud83e half a pair \udd16"
            })
    void textComesBackUnharmedWhateverItsLength(String text) {
        for (int times : new int[] {1, 7, 20, 61}) {
            String longText = text.repeat(times);
            StringBuilder joined = new StringBuilder();
            List<UserData> parts = MessageSplitter.split(longText, 9);
            parts.forEach(part -> joined.append(part.text()));

            assertEquals(longText, joined.toString());
            assertEquals(MessageSplitter.measure(longText).parts(), parts.size());
        }
    }

    @Test
    void anEscapeIsNeverPartedFromItsCode() {
        List<UserData> parts = MessageSplitter.split("a".repeat(152) + "€" + "b".repeat(20), 1);

        assertEquals("a".repeat(152), parts.get(0).text());
        assertEquals(159, parts.get(0).length());
        assertEquals("€" + "b".repeat(20), parts.get(1).text());
    }

    @Test
    void aSurrogatePairIsNeverCut() {
        List<UserData> parts = MessageSplitter.split("x".repeat(66) + "🤖" + "y".repeat(10), 1);

        assertEquals("x".repeat(66), parts.get(0).text());
        assertEquals("🤖" + "y".repeat(10), parts.get(1).text());
    }

    @Test
    void moreThan255PartsAreRefused() {
        assertEquals(255, MessageSplitter.split("a".repeat(255 * 153), 0).size());
        IllegalArgumentException refusal =
                assertThrows(IllegalArgumentException.class, () -> MessageSplitter.split("a".repeat(255 * 153 + 1), 0));
        assertTrue(refusal.getMessage().contains("256"), refusal.getMessage());
    }

    @Test
    void aMessageOfOnePartHasNoHeader() {
        assertFalse(MessageSplitter.split("a".repeat(160), 5).get(0).hasHeader());
        assertFalse(MessageSplitter.split("á".repeat(70), 5).get(0).hasHeader());
    }

    @Test
    void dataOctetsReadAsLatin1() {
        UserData data = new UserData(false, DataCodingScheme.OCTETS, 3, OctetString.ofHex("41f1ff"));

        assertEquals("Añÿ", data.text());
        assertEquals("41f1ff", data.body().toString());
    }

    @ParameterizedTest
    @CsvSource({
        "false, 0, 5, e8329bfd",
        "false, 0, 161, ''",
        "false, 8, 141, ''",
        "false, 8, 2, 00",
        "true, 8, 0, ''",
        "true, 8, 2, 0500",
        "true, 0, -1, ''"
    })
    void lengthsThatLieAreRefused(boolean hasHeader, int coding, int length, String hex) {
        assertThrows(
                IllegalArgumentException.class,
                () -> new UserData(hasHeader, new DataCodingScheme(coding), length, OctetString.ofHex(hex)));
    }

    @ParameterizedTest
    @CsvSource({
        "0500030102010041, 1:2:1", "0608040102020100, 258:2:1", "0500030102030041, ''", "0500030100010041, ''",
        "0500030102000041, ''", "0502020102010041, ''", "0500090102010041, ''", "02050000, ''",
        "0a05020102 0500030705 0141, ''"
    })
    void headersThatMakeNoSenseAreIgnored(String hex, String expected) {
        OctetString octets = OctetString.ofHex(hex.replace(" ", ""));
        UserData data = new UserData(true, DataCodingScheme.OCTETS, octets.length(), octets);

        assertEquals(
                expected,
                data.concatenation()
                        .map(place -> place.reference() + ":" + place.total() + ":" + place.part())
                        .orElse(""));
    }
}
