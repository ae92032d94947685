package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import vericommand.OrderText;
import vericommand.Pose;
import vericommand.Reply;
import vericommand.ReplyTone;
import vericommand.RobotStatus;
import vericommand.Verdict;

class ConsoleEventsTest {
    private final List<String> lines = new ArrayList<>();
    private final RobotEventPrinter events = new RobotEventPrinter("r1", event -> lines.add(event.toString()));

    @Test
    void eventsAreSpelledAsTheContractSays() {
        events.registered("5550200");
        events.unregistered("");
        events.unregistered("3");
        events.call("5550100");
        events.call("");
        events.key('#');
        events.order(Verdict.of(OrderText.read("** #** **"), RobotStatus.STOPPED));
        events.order(Verdict.of(OrderText.read("** #**20 **"), RobotStatus.COLLISION));
        events.outcome(new Reply(ReplyTone.EXECUTING, "Executing a command."));
        events.toneSent(ReplyTone.EXECUTED);
        events.replySent("5550100", "6 Executing a command.");
        events.message("5550100", "");
        events.released(16);
        events.status(RobotStatus.NO_MOTORS);
        events.sonar(new int[] {100, 5000});
        assertEquals(
                List.of(
                        "registered robot=r1 number=5550200",
                        "unregistered robot=r1",
                        "unregistered robot=r1 cause=3",
                        "call robot=r1 from=5550100",
                        "call robot=r1 from=\"\"",
                        "keys robot=r1 keys=#",
                        "order robot=r1 text=**#**** verdict=invalid",
                        "order robot=r1 text=**#**20** verdict=refused",
                        "outcome robot=r1 tone=6 text=\"Executing a command.\"",
                        "tone robot=r1 key=3",
                        "reply robot=r1 to=5550100 text=\"6 Executing a command.\"",
                        "sms robot=r1 from=5550100 text=\"\"",
                        "released robot=r1 cause=16",
                        "status robot=r1 value=\"No motors\"",
                        "sonar robot=r1 ranges=100,5000"),
                lines);
    }

    @Test
    void posesHaveADotWhateverTheLocaleNoMinusZeroAndHeadingsBelow360() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMANY);
            events.pose(new Pose(1.23456, -0.00001, 359.999));
            events.pose(new Pose(-12, 0, -90));
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
