package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import vericommand.LocalizedText;
import vericommand.RobotStatus;
import vericommand.VeriCommandSettings;

/** Calls that end by a lost link or a time-out, and what the robot does then; with a clock moved by hand. */
class CallEdgesTest {
    private VirtualSuite suite = new VirtualSuite();

    @Test
    void aMinuteWithoutAKeyClearsTheCallWithCause16AndTheReasonIsShown() {
        VirtualPhone phone = suite.inCall();
        suite.seconds(59);
        assertEquals(List.of(), phone.releaseCauses);
        suite.seconds(2);
        assertEquals(List.of(16), phone.releaseCauses);
        List<String> end = List.of("call-idle robot=robot seconds=60", "released robot=robot cause=16");
        List<String> lines = suite.robotLines;
        assertEquals(end, lines.subList(lines.size() - 2, lines.size()));
        LocalizedText shown = suite.telephone.veriCommand().verdictText();
        assertEquals("The call was ended: no key for 60 s.", shown.english());
    }

    @Test
    void aCallThatTheCallerEndsHasNoSuchReason() {
        VirtualPhone phone = suite.inCall();
        suite.seconds(59);
        phone.hangUp();
        suite.seconds(2);
        assertEquals(List.of(), suite.robotLines("call-idle"));
    }

    @Test
    void anyKeyStartsTheMinuteAgain() {
        VirtualPhone phone = suite.inCall();
        suite.seconds(55);
        phone.press("5");
        suite.seconds(58);
        assertEquals(List.of(), phone.releaseCauses);
        suite.seconds(3);
        assertEquals(List.of(16), phone.releaseCauses);
    }

    @Test
    void theMinuteDoesNotRunWhileAnOrderIsUnderWayAndStartsAgainAtItsReply() {
        VirtualPhone phone = suite.inCall();
        phone.press("** #**5000 **");
        suite.seconds(95);
        assertEquals("16", phone.tones());
        assertEquals(List.of(), phone.releaseCauses);
        suite.seconds(10);
        assertEquals("163", phone.tones());
        suite.seconds(50);
        assertEquals(List.of(), phone.releaseCauses);
        suite.seconds(10);
        assertEquals(List.of(16), phone.releaseCauses);
    }

    @Test
    void hangUpStopsTheRobotAndTheNextCallHearsNothingOfIt() {
        VirtualPhone phone = suite.inCall();
        phone.press("** #**100 **");
        suite.seconds(0.5);
        phone.hangUp();
        suite.seconds(5);
        assertEquals(RobotStatus.STOPPED, suite.robot.status());
        assertTrue(suite.robot.xMeters() < 0.9, "stood at " + suite.robot.xMeters());
        phone.dial(VirtualSuite.ROBOT);
        suite.seconds(5);
        assertEquals("161", phone.tones());
    }

    @Test
    void onHangupFinishLetsTheInstructionEndButBeginsNoOther() {
        suite = new VirtualSuite(VeriCommandSettings.OnHangup.FINISH);
        VirtualPhone phone = suite.inCall();
        phone.press("** #**100 #*#90 **");
        suite.seconds(0.5);
        phone.hangUp();
        suite.seconds(10);
        assertEquals(1, suite.robot.xMeters(), 0.001);
        assertEquals(0, suite.robot.headingRadians());
        phone.dial(VirtualSuite.ROBOT);
        suite.seconds(2);
        assertEquals("161", phone.tones());
    }

    @Test
    void twoSecondsWithoutSpeechAreALostCallAndTheRobotBrakes() {
        VirtualPhone phone = suite.inCall();
        phone.press("** #**500 **");
        suite.seconds(1);
        phone.link.loseSpeech();
        suite.seconds(1.9);
        assertEquals(List.of(), suite.robotLines("released"));
        assertEquals(RobotStatus.MOVING, suite.robot.status());
        suite.seconds(0.3);
        assertEquals(List.of("released robot=robot cause=41"), suite.robotLines("released"));
        assertEquals(List.of(41), phone.releaseCauses);
        suite.seconds(3);
        assertEquals(RobotStatus.STOPPED, suite.robot.status());
        assertEquals("16", phone.tones());
    }

    @Test
    void powerOffDuringAnOrderIsReportedByTwoAndThenTheCallIsCleared() {
        VirtualPhone phone = suite.inCall();
        phone.press("** #**100 **");
        suite.seconds(1);
        suite.robot.setPower(false);
        suite.settle();
        assertEquals(List.of(), phone.releaseCauses, "the tone has still to leave");
        suite.seconds(1);
        assertEquals("162", phone.tones());
        assertEquals(List.of(16), phone.releaseCauses);
        String outcome = suite.robotLines("outcome").get(0);
        assertTrue(
                outcome.matches(
                        ".*tone=2 text=\"Connection denied: the robot is off\\. Ended after \\d+ of 100 cm, .*"),
                outcome);
    }

    @Test
    void aPhoneThatRingsForThreeMinutesIsNoAnswer() {
        VirtualPhone caller = suite.phone(VirtualSuite.PHONE);
        VirtualPhone called = suite.phone("5550101");
        caller.dial("5550101");
        suite.seconds(179);
        assertEquals(List.of(), caller.releaseCauses);
        suite.seconds(3);
        assertEquals(List.of(19), caller.releaseCauses);
        assertEquals(1, called.releaseCauses.size());
    }

    @Test
    void aPhoneThatDoesNotAnswerItsPagingIsOutOfOrder() {
        VirtualPhone caller = suite.phone(VirtualSuite.PHONE);
        VirtualPhone called = suite.phone("5550101");
        called.link.loseAll();
        caller.dial("5550101");
        suite.seconds(8);
        assertEquals(List.of(), caller.releaseCauses);
        suite.seconds(2);
        assertEquals(List.of(27), caller.releaseCauses);
    }
}
