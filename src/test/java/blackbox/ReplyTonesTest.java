package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Every reply tone, heard by the phone in the audio that arrives. */
class ReplyTonesTest {
    Scenario scenario(String title) {
        return new Scenario(title);
    }

    @Test
    void oneCallHearsTonesOneSixThreeFourEightAndSevenAndNothingBetweenOrders() throws Exception {
        try (Scenario scenario = scenario("tones 1, 6, 3, 4, 8 and 7 in one call")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--speed", "8");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            robot.ask("place 9.5 0 0", "pose");

            scenario.tell("20 cm ahead are free");
            phone.say("press **#**20**");
            phone.expectNext("tone", "key", "6", "meaning", "executing");
            phone.expectNext("tone", "key", "3", "meaning", "executed");

            scenario.tell("the next 20 cm end at the wall after 5");
            phone.say("press **#**20**");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "4", "meaning", "collision");
            ConsoleEvent outcome = robot.expect("outcome", "tone", "4");
            assertTrue(outcome.field("text").contains("5 of 20 cm"), outcome.toString());

            scenario.tell("from Collision only turns are possible");
            phone.say("press **#**20**");
            phone.expectNext("tone", "key", "8", "meaning", "not possible in this status");
            phone.say("press **#*0**");
            phone.expectNext("tone", "key", "4");
            phone.say("press **#*#180#**20**");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");

            for (String broken :
                    List.of("**20**", "**#5#**20**", "**#**0**", "**#**12345**", "**#*#361**", "**#**2A**")) {
                scenario.tell(broken + " gets one seven at the offending key, the good order after it is read right");
                phone.say("press " + broken + " **#*#5**");
                robot.expect("order", "verdict", "invalid");
                phone.expectNext("tone", "key", "7", "meaning", "not a valid command");
                phone.expectNext("tone", "key", "6");
                phone.expectNext("tone", "key", "3");
            }

            scenario.tell("keys before an order and empty orders get no reply");
            phone.say("press 12#45*6 ** ***#*#5** 9 ****#*#5**");
            for (String tone : List.of("6", "3", "6", "3")) {
                phone.expectNext("tone", "key", tone);
            }
        }
    }

    @Test
    void aTreadmillMakesAnInfiniteLoop() throws Exception {
        try (Scenario scenario = scenario("tone 5")) {
            scenario.center();
            RunningProgram robot = scenario.robot("treadmill.map", "--speed", "8");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press **#**600**");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "5", "meaning", "infinite loop");
            assertEquals("Stopped", robot.ask("status", "status").field("value"));
        }
    }

    @Test
    void anotherOrderWhileMovingGetsSixAndStopGetsThreeWhenTheRobotStands() throws Exception {
        try (Scenario scenario = scenario("orders while moving")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press **#**500**");
            phone.expectNext("tone", "key", "6");
            phone.say("press **#*#90**");
            phone.expectNext("tone", "key", "6");
            phone.say("press **#*0**");
            phone.expectNext("tone", "key", "6");
            phone.say("press **###**");
            phone.expectNext("tone", "key", "3");
            assertEquals("Stopped", robot.ask("status", "status").field("value"));
        }
    }

    @Test
    void aCallerThatIsNoOperatorIsDenied() throws Exception {
        try (Scenario scenario = scenario("tone 2")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--operators", "5550101,5550102");
            RunningProgram stranger = scenario.phone(Scenario.PHONE);
            stranger.say("dial " + Scenario.ROBOT);
            stranger.expect("connected");
            stranger.expectNext("tone", "key", "2", "meaning", "connection denied");
            stranger.expect("released", "cause", "16");

            scenario.tell("his message is not answered, the operator's is");
            stranger.say("sms " + Scenario.ROBOT + " ** #**20 **");
            robot.expect("sms", "from", Scenario.PHONE);
            RunningProgram operator = scenario.phone("5550101");
            operator.say("sms " + Scenario.ROBOT + " ** #*0 **");
            operator.expect("sms", "from", Scenario.ROBOT);
            assertEquals(0, stranger.ask("inbox", "end").number("count"));
            robot.expectNext("reply", "to", "5550101");
        }
    }
}
