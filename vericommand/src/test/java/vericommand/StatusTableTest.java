package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StatusTableTest {
    @ParameterizedTest
    @CsvSource({
        "COLLISION,    REFUSED,  EXECUTED, EXECUTED, EXECUTED",
        "MOVING,       BUSY,     BUSY,     EXECUTED, EXECUTED",
        "STOPPED,      EXECUTED, EXECUTED, EXECUTED, EXECUTED",
        "NO_MOTORS,    REFUSED,  REFUSED,  REFUSED,  EXECUTED",
        "DISCONNECTED, DENIED,   DENIED,   DENIED,   DENIED"
    })
    void everyRowIsTheSpecifications(
            RobotStatus status,
            StatusTable.Treatment forward,
            StatusTable.Treatment turn,
            StatusTable.Treatment stop,
            StatusTable.Treatment report) {
        assertEquals(forward, StatusTable.treatment(status, new Instruction.Forward(1)));
        assertEquals(turn, StatusTable.treatment(status, new Instruction.Turn(1)));
        assertEquals(stop, StatusTable.treatment(status, new Instruction.Stop()));
        assertEquals(report, StatusTable.treatment(status, new Instruction.Report()));
    }

    @Test
    void aTreatmentHasItsTone() {
        assertEquals(ReplyTone.EXECUTED, StatusTable.Treatment.EXECUTED.tone());
        assertEquals(ReplyTone.NOT_POSSIBLE, StatusTable.Treatment.REFUSED.tone());
        assertEquals(ReplyTone.EXECUTING, StatusTable.Treatment.BUSY.tone());
        assertEquals(ReplyTone.CONNECTION_DENIED, StatusTable.Treatment.DENIED.tone());
    }

    @Test
    void anOrderIsJudgedByItsFirstInstruction() {
        Order wayOut = order(new Instruction.Turn(90), new Instruction.Forward(20));
        assertEquals("accepted", Verdict.of(wayOut, RobotStatus.COLLISION).word());
        Order ahead = order(new Instruction.Forward(20), new Instruction.Turn(90));
        assertEquals("refused", Verdict.of(ahead, RobotStatus.COLLISION).word());
        assertEquals(
                "accepted",
                Verdict.of(order(new Instruction.Report(), new Instruction.Forward(1)), RobotStatus.NO_MOTORS)
                        .word());
    }

    @Test
    void whileMovingOnlyAnOrderWithoutAnyMotionIsTaken() {
        Order stopAndReport = order(new Instruction.Stop(), new Instruction.Report());
        assertEquals("accepted", Verdict.of(stopAndReport, RobotStatus.MOVING).word());
        Order stopThenMove = order(new Instruction.Stop(), new Instruction.Turn(5));
        assertEquals(
                new Verdict.Refused(stopThenMove, RobotStatus.MOVING, ReplyTone.EXECUTING),
                Verdict.of(stopThenMove, RobotStatus.MOVING));
    }

    private static Order order(Instruction... instructions) {
        return new Order("**", List.of(instructions));
    }
}
