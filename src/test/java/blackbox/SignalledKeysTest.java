package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import org.junit.jupiter.api.Test;

/** Keys as START DTMF and STOP DTMF: the centre makes the sound, and the robot's modem hears it like any other. */
class SignalledKeysTest {
    @Test
    void signalledKeysDriveTheRobot() throws Exception {
        try (Scenario scenario = new Scenario("keys are signalled")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--speed", "10");
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--dtmf", "signalled");
            scenario.call(phone);
            for (String keys : new String[] {"**#**20#*#90**", "1234567890"}) {
                phone.say("press " + keys);
                for (char key : keys.toCharArray()) {
                    assertEquals(String.valueOf(key), robot.expectNext("keys").field("keys"));
                }
                phone.expectBefore(Set.of("error"), "sent", "keys", keys);
            }

            scenario.tell("the end of the input waits until the last tone has left");
            phone.say("press **#*#5**");
            phone.endInput();
            phone.expect("sent", "keys", "**#*#5**");
            assertEquals(0, phone.awaitExit());
        }
    }

    @Test
    void hangingUpDropsWhatIsLeft() throws Exception {
        try (Scenario scenario = new Scenario("hung up among the keys")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--speed", "10");
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--dtmf=signalled", "--codec=gsm");
            scenario.call(phone);
            phone.say("press 11111111111111111111");
            robot.expect("keys", "keys", "1");
            phone.say("hangup");
            phone.expectBefore(Set.of("sent"), "released", "cause", "16");
            robot.expect("released", "cause", "16");

            scenario.tell("the next call begins with no key of the old one");
            scenario.call(phone);
            phone.say("press 2");
            phone.expect("sent", "keys", "2");
            robot.expectNext("keys", "keys", "2");
        }
    }

    @Test
    void aPhoneThatSignalsIsHeardByAPhoneToo() throws Exception {
        try (Scenario scenario = new Scenario("from phone to phone")) {
            scenario.center();
            RunningProgram caller = scenario.phone("5550101", "--dtmf=signalled");
            RunningProgram called = scenario.phone("5550102");
            caller.say("dial 5550102");
            called.expect("ringing", "from", "5550101");
            called.say("answer");
            called.expect("connected");
            caller.expect("connected");
            caller.say("press 7777");
            called.say("press 33");
            caller.expectNext("tone", "key", "3");
            caller.expectNext("tone", "key", "3");
            caller.expect("sent", "keys", "7777");
            for (int i = 0; i < 4; i++) {
                called.expectNext("tone", "key", "7");
            }
            caller.say("hangup");
            ConsoleEvent released = called.expectBefore(Set.of("tone"), "released");
            assertTrue(released.matches("released", java.util.Map.of("cause", "16")), released.toString());
        }
    }
}
