package simgsm.center.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Msisdn;
import simgsm.console.Options;
import simgsm.console.UsageException;
import simgsm.sim.SimCard;
import simgsm.sim.SimFile;

class NewSimsTest {
    @TempDir
    Path folder;

    private Path list() {
        return folder.resolve("class.hlr");
    }

    private void make(String numbers) throws UsageException, IOException {
        NewSims.make(new Options("", "")
                .rows("--hlr FILE\n--new-sim N")
                .parse(List.of("--hlr", list().toString(), "--new-sim", numbers)));
    }

    @Test
    void aNewCardStandsInTheListAndInAFileOfItsOwn() throws Exception {
        make("5550100,5550200");
        SimFile list = SimFile.read(list());
        assertEquals(2, list.subscriptions().size());
        SimCard card = SimFile.read(folder.resolve("5550200.sim")).onlyCard().orElseThrow();
        assertEquals(list.cardOf(new Msisdn("5550200")).orElseThrow(), card);
        assertEquals("001010005550200", card.imsi().digits());
        assertNotEquals(
                card.k(), list.cardOf(new Msisdn("5550100")).orElseThrow().k());
    }

    @Test
    void laterCardsComeBehindTheEarlierOnesEvenWithoutALineEnd() throws Exception {
        make("1");
        Files.writeString(list(), Files.readString(list()).stripTrailing());
        make("5-7");
        assertEquals("1, 5, 6, 7", SimFile.read(list()).numbers());
    }

    @Test
    void keysAreTheirOwnersAlone() throws Exception {
        make("1");
        if (folder.getFileSystem().supportedFileAttributeViews().contains("posix")) {
            for (Path file : List.of(list(), folder.resolve("1.sim"))) {
                assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
            }
        }
    }

    @Test
    void aNumberThatHasACardGetsNoSecondOne() throws Exception {
        make("1");
        String before = Files.readString(list());
        UsageException twice = assertThrows(UsageException.class, () -> make("2,1"));
        assertEquals("--new-sim: there is already the SIM of 1, IMSI 001010000000001", twice.getMessage());
        assertEquals(before, Files.readString(list()));
        assertTrue(Files.notExists(folder.resolve("2.sim")));
    }

    @Test
    void aCardFileThatIsThereIsNotOverwritten() throws Exception {
        Files.writeString(folder.resolve("2.sim"), "precious");
        IOException refused = assertThrows(IOException.class, () -> make("1-2"));
        assertTrue(refused.getMessage().startsWith(folder.resolve("2.sim") + ": there already"), refused.getMessage());
        assertTrue(Files.notExists(list()));
        assertTrue(Files.notExists(folder.resolve("1.sim")));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "abc | found abc",
                "0123 | found 0123",
                "12345678901 | found 12345678901",
                "1, | found none",
                "5-3 | expected the smaller number first, found 5-3",
                "1-1001 | expected at most 1000 numbers",
                "1-9999999999 | expected at most 1000 numbers",
            })
    void nonsenseIsRefusedSayingWhatWasExpected(String numbers, String error) {
        UsageException refused = assertThrows(UsageException.class, () -> make(numbers));
        assertTrue(refused.getMessage().startsWith("--new-sim: expected "), refused.getMessage());
        assertTrue(refused.getMessage().endsWith(error), refused.getMessage());
    }

    @Test
    void withoutAListNothingIsMade() throws Exception {
        UsageException refused = assertThrows(
                UsageException.class,
                () -> NewSims.make(
                        new Options("", "").rows("--hlr FILE\n--new-sim N").parse(List.of("--new-sim=1"))));
        assertTrue(refused.getMessage().contains("--hlr"), refused.getMessage());
    }
}
