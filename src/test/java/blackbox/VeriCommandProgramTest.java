package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code vericommand.jar}: the verdict on an order in a status, without a robot. */
class VeriCommandProgramTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Stopped|** #**20 **|0",
                "Stopped|** #*#90 #**100 ** |0",
                "Collision|** #**20 **|1",
                "Collision|** #*#90 #**20 **|0",
                "No motors|** #**20 **|1",
                "No motors|** #*0 **|0",
                "Disconnected|** #*0 **|1",
                "Moving|** ### **|0",
                "Moving|** #**20 **|1",
                "Stopped|** #** **|1",
                "Stopped|hello|1"
            })
    void theExitStatusSaysWhetherTheOrderWouldBeTaken(String status, String order, int exit) throws Exception {
        FinishedProgram verdict = FinishedProgram.run("vericommand", "--status", status, order);
        assertEquals(exit, verdict.status(), verdict.output() + verdict.error());
        assertFalse(verdict.output().isBlank());
    }

    @Test
    void theFailingPositionIsMarked() throws Exception {
        FinishedProgram verdict = FinishedProgram.run("vericommand", "--lang=en", "** #** **");
        assertEquals(1, verdict.status());
        assertTrue(verdict.output().contains("number expected at key 6"), verdict.output());
        String[] lines = verdict.output().split("\\R");
        int marked = -1;
        for (int i = 1; i < lines.length; i++) {
            if (lines[i].strip().equals("^")) {
                marked = i;
            }
        }
        assertTrue(marked > 0, verdict.output());
        assertEquals('*', lines[marked - 1].charAt(lines[marked].indexOf('^')), verdict.output());
    }

    @Test
    void withoutAnOrderTheUsageIsSaid() throws Exception {
        FinishedProgram refused = FinishedProgram.run("vericommand");
        assertEquals(2, refused.status());
        assertTrue(refused.error().contains("--help"), refused.error());
    }
}
