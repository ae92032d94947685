package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import vericommand.RobotStatus;
import vericommand.VeriCommandSettings;

/** SMS orders beside calls and beside one another; with a clock moved by hand. */
class MessageEdgesTest {
    private static final String SECOND = "5550101";

    private VirtualSuite suite = new VirtualSuite();

    @Test
    void whoIsNoOperatorGetsNoReplyAndMovesNothing() {
        suite = new VirtualSuite(VeriCommandSettings.OnHangup.STOP, VirtualSuite.PHONE);
        VirtualPhone operator = suite.phone(VirtualSuite.PHONE);
        VirtualPhone stranger = suite.phone(SECOND);
        stranger.message(VirtualSuite.ROBOT, "** #**20 **");
        stranger.message(VirtualSuite.ROBOT, "nonsense");
        suite.seconds(30);
        assertEquals(2, stranger.sentCount, "the network delivers, the robot is silent");
        assertEquals(List.of(), stranger.messages);
        assertEquals(0, suite.robot.xMeters());
        operator.message(VirtualSuite.ROBOT, "** #**20 **");
        suite.seconds(10);
        assertEquals(List.of("3 Done: #**20. Stopped at 0.200 0.000 m, heading 0.0."), operator.messages);
    }

    /** Without end before: each reply was answered by another one. */
    @Test
    void aRobotDoesNotAnswerARobot() {
        suite.telephone.station().sendMessage(new Msisdn(VirtualSuite.ROBOT), "hello");
        suite.seconds(10);
        assertEquals(
                List.of("reply robot=robot to=5550200 text=\"7 Not a valid command: ** expected at key 1.\""),
                suite.robotLines("reply"));
        assertEquals(2, suite.robotLines("sms ").size());
        suite.telephone.station().sendMessage(new Msisdn(VirtualSuite.ROBOT), "** #**20 **");
        suite.seconds(10);
        assertEquals(2, suite.robotLines("reply").size());
        assertEquals(4, suite.robotLines("sms ").size());
        assertEquals(2, suite.robotLines("order ").size());
    }

    @Test
    void whileAnOrderMovesAnotherIsAnsweredBySixButStopAndReportAreTaken() {
        VirtualPhone first = suite.phone(VirtualSuite.PHONE);
        VirtualPhone second = suite.phone(SECOND);
        first.message(VirtualSuite.ROBOT, "** #**500 **");
        suite.seconds(2);
        second.message(VirtualSuite.ROBOT, "** #**20 **");
        suite.seconds(2);
        assertEquals(List.of("6 Executing a command."), second.messages);
        second.message(VirtualSuite.ROBOT, "** #*0 **");
        suite.seconds(2);
        assertTrue(second.messages.get(1).startsWith("6 Executing a command. Moving at "), second.messages.get(1));
        second.message(VirtualSuite.ROBOT, "** ### **");
        suite.seconds(5);
        assertTrue(second.messages.get(2).startsWith("3 Done: ###. Stopped at "), second.messages.get(2));
        assertEquals(1, first.messages.size());
        assertTrue(first.messages.get(0).matches("8 Stopped by order after \\d+ of 500 cm"), first.messages.get(0));
    }

    @Test
    void anOrderByMessageUnderWayMakesNoCallBusyAndOutlivesIt() {
        VirtualPhone first = suite.phone(VirtualSuite.PHONE);
        VirtualPhone second = suite.phone(SECOND);
        first.message(VirtualSuite.ROBOT, "** #**500 **");
        suite.seconds(2);
        second.dial(VirtualSuite.ROBOT);
        suite.seconds(0.5);
        assertEquals("1", second.tones());
        second.press("** #**20 **");
        suite.seconds(1);
        assertEquals("16", second.tones());
        second.hangUp();
        suite.seconds(1);
        assertEquals(RobotStatus.MOVING, suite.robot.status(), "the call's end stops only what the call ordered");
        suite.seconds(15);
        assertEquals(List.of("3 Done: #**500. Stopped at 5.000 0.000 m, heading 0.0."), first.messages);
        assertEquals("16", second.tones());
    }
}
