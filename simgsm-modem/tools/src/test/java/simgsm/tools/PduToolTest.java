package simgsm.tools;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PduToolTest {
    @Test
    void aShortTextIsOneLine() {
        assertEquals("0,0,5,e8329bfd06", PduTool.encode("hello", 0x2a));
        assertEquals("0,8,2,00e1", PduTool.encode("á", 0x2a));
        assertEquals("0,0,0,", PduTool.encode("", 0x2a));
    }

    @Test
    void aLongTextIsALineForEachPart() {
        String[] lines = PduTool.encode("a".repeat(161), 0x2a).split("\n");

        assertEquals(2, lines.length);
        assertTrue(lines[0].startsWith("1,0,160,0500032a0201"), lines[0]);
        assertTrue(lines[1].startsWith("1,0,15,0500032a0202"), lines[1]);
    }

    @Test
    void aSubmitIsReportedInWords() {
        assertEquals("""
                SMS-SUBMIT
                TP-RD: take duplicates
                TP-SRR: status report requested
                TP-MR: 1
                TP-DA: 491700000002 (international, plan 1)
                TP-PID: 0
                TP-DCS: 0 GSM 7-bit
                TP-VP: 167, 24 h
                TP-UDL: 5 septets
                text: hello""", PduTool.decode("31010c919471000000200000a7 05 E8329BFD06"));
    }

    @Test
    void aDeliverAndAReportAreReportedInWords() {
        String deliver = PduTool.decode("440c91947100000010000462111221000040070500032a020141");
        String report = PduTool.decode("06010c91947100000020621112210000406211122100004046");

        assertTrue(deliver.contains("TP-UDH: part 1 of 2, reference 42\ndata: 41"), deliver);
        assertTrue(deliver.contains("TP-SCTS: 2026-11-21T12:00+01:00"), deliver);
        assertTrue(report.contains("TP-ST: 70 validity period expired"), report);
    }

    @ParameterizedTest
    @ValueSource(strings = {"00", "0791947101670000", "0581214365f7"})
    void theAddressOfTheServiceCentreBeforeAUnitIsLeftOut(String address) {
        String submit = "31010c919471000000200000a705E8329BFD06";
        String deliver = "440c91947100000010000462111221000040070500032a020141";

        assertEquals(PduTool.decode(submit), PduTool.decode(address + submit));
        assertEquals(PduTool.decode(deliver), PduTool.decode(address + deliver));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "3", "zz", "03", "3101", "31010c919471000000200000a705e832"})
    void whatIsNoUnitIsRefusedInWords(String hex) {
        IllegalArgumentException refusal = assertThrows(IllegalArgumentException.class, () -> PduTool.decode(hex));

        assertTrue(refusal.getMessage().contains("TPDU"), refusal.getMessage());
    }
}
