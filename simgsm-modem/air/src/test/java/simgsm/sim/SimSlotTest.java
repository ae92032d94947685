package simgsm.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.air.Msisdn;

class SimSlotTest {
    private static final String KEYS = " k=465b5ce8b199b49faa5f0a2ee238a6bc opc=cd63cb71954a9f4e48a5994e37a02baf";
    private static final String FIRST = "sim number=5550100 imsi=001010005550100" + KEYS;
    private static final String SECOND = "sim number=5550101 imsi=001010005550101" + KEYS;

    @TempDir
    Path folder;

    @Test
    void withoutTheOptionThereIsNoCard() throws Exception {
        SimSlot slot = SimSlot.of(Optional.empty());
        assertTrue(slot.isEmpty());
        assertTrue(slot.card(Optional.empty()).isEmpty());
    }

    @Test
    void theOnlyCardOfAFileNeedsNoNumber() throws Exception {
        assertEquals(
                new Msisdn("5550100"),
                slot(FIRST).card(Optional.empty()).orElseThrow().number());
    }

    @Test
    void ofSeveralCardsTheNumberChooses() throws Exception {
        SimSlot slot = slot(FIRST, SECOND);
        assertEquals(
                new Msisdn("5550101"),
                slot.card(Optional.of(new Msisdn("5550101"))).orElseThrow().number());
        IllegalArgumentException open = assertThrows(IllegalArgumentException.class, () -> slot.card(Optional.empty()));
        assertEquals(
                "--sim: " + folder.resolve("sims") + " holds 2 SIMs (5550100, 5550101), choose one with --number",
                open.getMessage());
    }

    @Test
    void aNumberThatTheFileDoesNotHoldIsNamed() throws Exception {
        IllegalArgumentException none =
                assertThrows(IllegalArgumentException.class, () -> slot(FIRST).card(Optional.of(new Msisdn("7"))));
        assertEquals(
                "--sim: " + folder.resolve("sims") + " holds the SIM of 5550100, not that of 7", none.getMessage());
    }

    @Test
    void aFileThatIsNotThereIsAnInputOutputError() {
        assertThrows(IOException.class, () -> SimSlot.of(Optional.of(folder.resolve("sims"))));
    }

    private SimSlot slot(String... lines) throws Exception {
        Files.write(folder.resolve("sims"), List.of(lines));
        return SimSlot.of(Optional.of(folder.resolve("sims")));
    }
}
