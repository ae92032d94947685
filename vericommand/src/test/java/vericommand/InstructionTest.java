package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class InstructionTest {
    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 10000})
    void aForwardOutOfRangeCannotBeBuilt(int centimeters) {
        String message = assertThrows(IllegalArgumentException.class, () -> new Instruction.Forward(centimeters))
                .getMessage();
        assertTrue(message.contains("1..9999") && message.contains("" + centimeters), message);
    }

    @ParameterizedTest
    @ValueSource(ints = {-90, 0, 361})
    void aTurnOutOfRangeCannotBeBuilt(int degrees) {
        String message = assertThrows(IllegalArgumentException.class, () -> new Instruction.Turn(degrees))
                .getMessage();
        assertTrue(message.contains("1..360") && message.contains("" + degrees), message);
    }

    @Test
    void theBoundsThemselvesAreInRange() {
        assertEquals("#**1", new Instruction.Forward(1).keys());
        assertEquals("#**9999", new Instruction.Forward(9999).keys());
        assertEquals("#*#1", new Instruction.Turn(1).keys());
        assertEquals("#*#360", new Instruction.Turn(360).keys());
    }

    @Test
    void anOrderHasOneToThirtyTwoInstructions() {
        assertThrows(IllegalArgumentException.class, () -> new Order("****", List.of()));
        List<Instruction> most = Collections.nCopies(32, new Instruction.StopNow());
        assertEquals(32, new Order("**", most).instructions().size());
        List<Instruction> tooMany = Collections.nCopies(33, new Instruction.StopNow());
        assertThrows(IllegalArgumentException.class, () -> new Order("**", tooMany));
    }

    @Test
    void anOrderKnowsWhetherItMovesOrStops() {
        Order order = new Order("**", List.of(new Instruction.ReportStatus(), new Instruction.Turn(5)));
        assertTrue(order.moves());
        assertFalse(order.stops());
        Order stop = new Order("**", List.of(new Instruction.StopNow()));
        assertFalse(stop.moves());
        assertTrue(stop.stops());
    }

    @Test
    void anOrderIsWrittenInKeysAndInWords() {
        Order order = new Order(
                "**#**0020#*#90####*0**",
                List.of(
                        new Instruction.Forward(20),
                        new Instruction.Turn(90),
                        new Instruction.StopNow(),
                        new Instruction.ReportStatus()));
        assertEquals("** #**20 #*#90 ### #*0 **", order.text());
        assertEquals("forward 20 cm, turn right 90 degrees, stop, report the status", order.words(Locale.ENGLISH));
        assertEquals(
                "avanzar 20 cm, girar 90 grados a la derecha, parar, informar del estado",
                order.words(Locale.forLanguageTag("es")));
    }

    @Test
    void aPoseOrAnOutcomeWithoutANumberCannotBeBuilt() {
        assertThrows(IllegalArgumentException.class, () -> new Pose(Double.NaN, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> new Pose(0, 0, Double.POSITIVE_INFINITY));
        assertThrows(IllegalArgumentException.class, () -> new MotionOutcome(MotionOutcome.Ending.DONE, -0.1));
        assertThrows(IllegalArgumentException.class, () -> new MotionOutcome(MotionOutcome.Ending.DONE, Double.NaN));
    }
}
