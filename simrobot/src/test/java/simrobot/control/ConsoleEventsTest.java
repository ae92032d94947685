package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import vericommand.OrderText;
import vericommand.Pose;
import vericommand.RobotStatus;
import vericommand.Verdict;

class ConsoleEventsTest {
    private final List<String> lines = new ArrayList<>();

    private void tell(RobotEvent event) {
        lines.add(event.line("r1").toString());
    }

    private static RobotEvent verified(Verdict verdict) {
        return new RobotEvent.OrderVerified(verdict.keys(), verdict.word());
    }

    @Test
    void eventsAreSpelledAsTheContractSays() {
        tell(new RobotEvent.Registered("5550200"));
        tell(new RobotEvent.Unregistered(""));
        tell(new RobotEvent.Unregistered("3"));
        tell(new RobotEvent.CallRinging("5550100"));
        tell(new RobotEvent.CallReceived("5550100"));
        tell(new RobotEvent.CallReceived(""));
        tell(new RobotEvent.KeyReceived('#'));
        tell(verified(Verdict.of(OrderText.read("** #** **"), RobotStatus.STOPPED)));
        tell(verified(Verdict.of(OrderText.read("** #**20 **"), RobotStatus.COLLISION)));
        tell(new RobotEvent.OrderAnswered(6, "Executing a command."));
        tell(new RobotEvent.ToneSent('3'));
        tell(new RobotEvent.ReplySent("5550100", "6 Executing a command."));
        tell(new RobotEvent.MessageReceived("5550100", ""));
        tell(new RobotEvent.UssdAnswered("** #*0 **", "Stopped at 0.000 0.000 m, heading 0.0."));
        tell(new RobotEvent.CallIdle(60));
        tell(new RobotEvent.CallReleased(16));
        tell(new RobotEvent.StatusChanged(RobotStatus.NO_MOTORS));
        assertEquals(
                List.of(
                        "registered robot=r1 number=5550200",
                        "unregistered robot=r1",
                        "unregistered robot=r1 cause=3",
                        "ringing robot=r1 from=5550100",
                        "call robot=r1 from=5550100",
                        "call robot=r1 from=\"\"",
                        "keys robot=r1 keys=#",
                        "order robot=r1 text=**#**** verdict=invalid",
                        "order robot=r1 text=**#**20** verdict=refused",
                        "outcome robot=r1 tone=6 text=\"Executing a command.\"",
                        "tone robot=r1 key=3",
                        "reply robot=r1 to=5550100 text=\"6 Executing a command.\"",
                        "sms robot=r1 from=5550100 text=\"\"",
                        "ussd robot=r1 text=\"** #*0 **\" reply=\"Stopped at 0.000 0.000 m, heading 0.0.\"",
                        "call-idle robot=r1 seconds=60",
                        "released robot=r1 cause=16",
                        "status robot=r1 value=\"No motors\""),
                lines);
    }

    @Test
    void posesHaveADotWhateverTheLocaleNoMinusZeroAndHeadingsBelow360() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMANY);
            tell(new RobotEvent.PoseReported(new Pose(1.23456, -0.00001, 359.999)));
            tell(new RobotEvent.PoseReported(new Pose(-12, 0, -90)));
        } finally {
            Locale.setDefault(before);
        }
        assertEquals(
                List.of(
                        "pose robot=r1 x=1.2346 y=0.0000 heading=0.00",
                        "pose robot=r1 x=-12.0000 y=0.0000 heading=270.00"),
                lines);
    }
}
