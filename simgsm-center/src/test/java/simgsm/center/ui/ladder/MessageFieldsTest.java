package simgsm.center.ui.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.center.msc.LadderEntry;
import simgsm.center.ui.Scene;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText;

class MessageFieldsTest {
    @Test
    void aSetupIsFieldsAndOctets() {
        assertEquals("""
                send sequence number  0
                transaction           0, opened by the sender
                called                5550200
                bearer capability     speech, full rate preferred, versions FR3 FR2 FR1 HR3 HR1

                0000  03 05 04 06 60 04 02 00 05 81 5e 05 81 55 05 02
                0010  f0""", words(Scene.setup()));
    }

    @Test
    void aShortMessageIsExplainedInSpanishToo() {
        LadderRow submit = new LadderRow(1, Scene.submit("hola"));
        String words = MessageFields.lines(MessageFields.of(submit, Locale.forLanguageTag("es")));

        assertTrue(words.startsWith("transacción           0, abierta por el emisor\n"), words);
        assertTrue(words.contains("TP-UDL                4 septetos\n"), words);
        assertTrue(words.contains("aceptar duplicados"), words);
    }

    @Test
    void aSetupsNumberStandsInItsElementOfTheOctets() {
        MessageText setup = MessageFields.of(new LadderRow(1, Scene.setup()), Locale.ROOT);

        assertEquals("{10, 11, 12, 13, 14, 15, 16}", setup.octetsOf(2).toString());
        assertEquals(2, setup.fieldAt(13));
    }

    @Test
    void aShortMessagesFieldsStandInTheOctetsOfItsTransferUnit() {
        MessageText submit = MessageFields.of(new LadderRow(1, Scene.submit("** #*#90 **")), Locale.ROOT);
        var names = submit.fields().stream().map(field -> field.name()).toList();
        int length = submit.octets().length();

        assertEquals(length - 1, submit.octetsOf(names.indexOf("text")).length() - 1);
        assertEquals(1, submit.octetsOf(names.indexOf("TP-MR")).cardinality());
        assertEquals(names.indexOf("text"), submit.fieldAt(length - 1));
    }

    @Test
    void aShortMessageShowsItsTextFirst() {
        String words = words(Scene.submit("** #*#90 **"));

        assertTrue(words.contains("text                  ** #*#90 **\n"), words);
        assertTrue(words.contains("TP-DA                 5550200 (unknown, plan 1)"), words);
    }

    /** TS 24.007, 11.2.3.1.1: 0x0B is non call related supplementary services; with the transaction's flag 0x8B. */
    @ParameterizedTest
    @CsvSource({"0b3b00, SS", "8b2a00, SS", "0305, CC", "0508, MM", "0901, SMS", "0606, RR"})
    void aMessageHasTheTagOfItsProtocolDiscriminator(String octets, String tag) {
        LadderEntry entry =
                new LadderEntry(Instant.EPOCH, LadderEntry.CENTER, "5550100", "message", OctetString.ofHex(octets));

        assertEquals(tag, Protocol.of(entry).tag());
    }

    @Test
    void aTowersMessageIsElementsAndOctets() {
        LadderEntry entry = new LadderEntry(
                Instant.EPOCH,
                LadderEntry.CENTER,
                "west",
                "ip.access MDCX",
                OctetString.ofHex("7e730109f80001f07f000001f10fa4f400f203"));

        assertEquals(Protocol.COMMON_CHANNEL, Protocol.of(entry));
        assertEquals("""
                channel number        TCH/F 1
                connection identifier 0001
                remote ip             127.0.0.1
                remote port           4004
                speech mode           00
                rtp payload           3

                0000  7e 73 01 09 f8 00 01 f0 7f 00 00 01 f1 0f a4 f4
                0010  00 f2 03""", words(entry));
    }

    @Test
    void aBroadcastPageShowsItsText() {
        String words = words(Scene.broadcast("Attention"));

        assertTrue(words.startsWith("channel               50\n"), words);
        assertTrue(words.contains("text                  Attention"), words);
        assertTrue(words.contains("page                  1 of 1"), words);
    }

    @Test
    void aBrokenMessageSaysWhatIsWrong() {
        String words = words(Scene.broken());

        assertTrue(words.contains("96 invalid mandatory information"), words);
        assertTrue(words.endsWith("0000  03 35 2c 45"), words);
    }

    @Test
    void octetsThatAreNothingAreShownAllTheSame() {
        for (String hex : new String[] {"", "0c", "0c1501900e", "ff", "0901ff", "0901050001000000"}) {
            LadderEntry entry = new LadderEntry(Scene.NOON, "5550100", "M3", "?", OctetString.ofHex(hex));
            assertTrue(words(entry).replace(" ", "").endsWith(hex), hex);
        }
    }

    private static String words(LadderEntry entry) {
        return MessageFields.lines(MessageFields.of(new LadderRow(1, entry), Locale.ROOT));
    }
}
