package simgsm.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;

class SimFileTest {
    private static final String K = "465b5ce8b199b49faa5f0a2ee238a6bc";
    private static final String OP = "cdc202d5123e20f62b6d676ac72cb318";
    private static final String OPC = "cd63cb71954a9f4e48a5994e37a02baf";
    private static final String GOOD = "sim number=5550100 imsi=001010005550100 k=" + K + " opc=" + OPC;

    @TempDir
    Path folder;

    @Test
    void cardsAreReadWithCommentsBlanksAndAnyOrderOfTheFields() throws IOException {
        SimFile file = read(
                "\ufeff# our class",
                "",
                "  " + GOOD + "   # Ana",
                "sim opc=" + OPC.toUpperCase() + "\tk=" + K + " imsi=262420000000017 number=5550101 barred",
                "barred-imei 490154203237518");
        assertEquals(2, file.subscriptions().size());
        SimCard first = file.cardOf(new Msisdn("5550100")).orElseThrow();
        assertEquals(new Imsi("001010005550100"), first.imsi());
        assertEquals(K, first.k().toString());
        assertEquals(OPC, first.opc().orElseThrow().toString());
        assertFalse(file.subscriptions().get(0).isBarred());
        assertTrue(file.subscriptions().get(1).isBarred());
        assertEquals(OPC, file.subscriptions().get(1).card().opc().orElseThrow().toString());
        assertEquals(Set.of(new Imei("490154203237518")), file.barredEquipment());
        assertTrue(file.onlyCard().isEmpty());
        assertEquals("5550100, 5550101", file.numbers());
    }

    @Test
    void fromTheOperatorsValueTheCardsOwnIsMade() throws IOException {
        SimFile file = read("sim number=5550100 imsi=001010005550100 k=" + K + " op=" + OP);
        assertEquals(OPC, file.onlyCard().orElseThrow().opc().orElseThrow().toString());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "hello world | expected sim ... or barred-imei IMEI, found hello",
                "sim number=5550100 | expected imsi=, found none",
                "sim imsi=001010005550100 | expected number=, found none",
                "sim number=abc imsi=001010005550100 | \"abc\" is not a telephone number of 1 to 15 digits",
                "sim number=5550100 imsi=12 | IMSI \"12\" is not 6 to 15 digits",
                "sim number=5550100 number=5550101 | expected number= once, found it twice",
                "sim number=5550100 ki=00 | expected number=, imsi=, k=, opc= (or op=), algorithm=, pin=, puk=, pin-enabled= or barred, found ki=",
                "sim number=5550100 blocked | expected number=, imsi=, k=, opc= (or op=), algorithm=, pin=, puk=, pin-enabled= or barred, found blocked",
                "sim number=1 imsi=001010000000001 k=12 opc=34 | expected k= with 32 hexadecimal digits, found 2 characters",
                "sim number=1 imsi=001010000000001 k=K algorithm=xor | expected algorithm= with one of milenage, comp128v1, comp128v2, comp128v3, found xor",
                "sim number=1 imsi=001010000000001 k=K algorithm=comp128v1 opc=K | expected neither opc= nor op= with comp128v1",
                "sim number=1 imsi=001010000000001 k=K opc=K puk=12345678 | expected pin=, found none",
                "sim number=1 imsi=001010000000001 k=K opc=K pin=1234 | expected puk=, found none",
                "sim number=1 imsi=001010000000001 k=K opc=K pin=123 puk=12345678 | expected pin= with 4 to 8 digits",
                "sim number=1 imsi=001010000000001 k=K opc=K pin=1234 puk=123 | expected puk= with 8 digits",
                "sim number=1 imsi=001010000000001 k=K opc=K pin=1234 puk=12345678 pin-enabled=no | expected pin-enabled= with true or false, found no",
                "sim number=1 imsi=001010000000001 k=K opc=K pin=1234 puk=12345678 pin-tries=x | expected pin-tries= with 0 to 3, found x",
                "barred-imei | expected one IMEI after barred-imei, found 0 words",
                "barred-imei 490154203237517 | IMEI \"490154203237517\" has a wrong check digit, expected 8",
            })
    void anErrorNamesFileLineAndWhatWasExpected(String line, String error) {
        IOException refused = assertThrows(IOException.class, () -> read("# first", line.replace("=K", "=" + K)));
        assertEquals(folder.resolve("class.hlr") + ", line 2: " + error, refused.getMessage());
    }

    @Test
    void aKeyIsNeverShownInAnError() {
        String almost = K.substring(1) + "x";
        IOException refused =
                assertThrows(IOException.class, () -> read("sim number=1 imsi=001010000000001 k=" + almost));
        assertTrue(refused.getMessage().endsWith("found 32 characters, not all of them hexadecimal digits"));
        assertFalse(refused.getMessage().contains(almost));
    }

    @Test
    void bothFormsOfTheOperatorsValueOrNoneAreRefused() {
        String card = "sim number=1 imsi=001010000000001 k=" + K;
        assertTrue(
                assertThrows(IOException.class, () -> read(card)).getMessage().endsWith("found neither"));
        assertTrue(assertThrows(IOException.class, () -> read(card + " op=" + OP + " opc=" + OPC))
                .getMessage()
                .endsWith("found both"));
    }

    @Test
    void aNumberOrAnImsiThatStandsTwiceIsNamedWithItsFirstLine() {
        IOException sameNumber = assertThrows(IOException.class, () -> read(GOOD, GOOD));
        assertTrue(
                sameNumber.getMessage().endsWith("expected each number once, found 5550100, which line 1 has already"));
        IOException sameImsi =
                assertThrows(IOException.class, () -> read(GOOD, GOOD.replace("number=5550100", "number=5550101")));
        assertTrue(sameImsi.getMessage().contains("line 2: expected each IMSI once, found 001010005550100"));
    }

    @Test
    void whatIsNoTextIsRefused() throws IOException {
        Path file = folder.resolve("binary");
        Files.write(file, new byte[] {(byte) 0xc3, (byte) 0x28});
        assertEquals(
                file + ": octet 1: expected UTF-8, found C3",
                assertThrows(IOException.class, () -> SimFile.read(file)).getMessage());
    }

    @Test
    void aByteOrderMarkIsNoPartOfTheFirstLine() throws IOException {
        assertEquals(1, read("\uFEFF" + GOOD).subscriptions().size());
    }

    @Test
    void aCardInALogShowsNoKey() throws IOException {
        assertEquals(
                "SIM of 5550100, IMSI 001010005550100",
                read(GOOD).onlyCard().orElseThrow().toString());
    }

    private SimFile read(String... lines) throws IOException {
        Path file = folder.resolve("class.hlr");
        Files.write(file, List.of(lines));
        return SimFile.read(file);
    }
}
