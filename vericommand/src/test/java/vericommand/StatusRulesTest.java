package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StatusRulesTest {
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
            StatusRules.Treatment forward,
            StatusRules.Treatment turn,
            StatusRules.Treatment stop,
            StatusRules.Treatment report) {
        assertEquals(forward, StatusRules.treatment(status, new Instruction.Forward(1)));
        assertEquals(turn, StatusRules.treatment(status, new Instruction.Turn(1)));
        assertEquals(stop, StatusRules.treatment(status, new Instruction.StopNow()));
        assertEquals(report, StatusRules.treatment(status, new Instruction.ReportStatus()));
    }

    @Test
    void aTreatmentHasItsTone() {
        assertEquals(ReplyTone.EXECUTED, StatusRules.Treatment.EXECUTED.tone());
        assertEquals(ReplyTone.NOT_POSSIBLE, StatusRules.Treatment.REFUSED.tone());
        assertEquals(ReplyTone.EXECUTING, StatusRules.Treatment.BUSY.tone());
        assertEquals(ReplyTone.CONNECTION_DENIED, StatusRules.Treatment.DENIED.tone());
    }

    @Test
    void anOrderIsJudgedByItsFirstInstruction() {
        Order wayOut = order(new Instruction.Turn(90), new Instruction.Forward(20));
        assertEquals("accepted", Verdict.of(wayOut, RobotStatus.COLLISION).word());
        Order ahead = order(new Instruction.Forward(20), new Instruction.Turn(90));
        assertEquals("refused", Verdict.of(ahead, RobotStatus.COLLISION).word());
        assertEquals(
                "accepted",
                Verdict.of(order(new Instruction.ReportStatus(), new Instruction.Forward(1)), RobotStatus.NO_MOTORS)
                        .word());
    }

    @Test
    void whileMovingOnlyAnOrderWithoutAnyMotionIsTaken() {
        Order stopAndReport = order(new Instruction.StopNow(), new Instruction.ReportStatus());
        assertEquals("accepted", Verdict.of(stopAndReport, RobotStatus.MOVING).word());
        Order stopThenMove = order(new Instruction.StopNow(), new Instruction.Turn(5));
        assertEquals(
                new Verdict.Refused(stopThenMove, RobotStatus.MOVING, ReplyTone.EXECUTING),
                Verdict.of(stopThenMove, RobotStatus.MOVING));
    }

    private static Order order(Instruction... instructions) {
        return new Order("**", List.of(instructions));
    }
}
