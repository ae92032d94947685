package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Centre, phone or robot vanish: the others say so, stay well, and are together again without help. */
class RecoveryTest {
    @Test
    void theCentreIsKilledWhileIdleAndBothSidesRegisterAgain() throws Exception {
        try (Scenario scenario = new Scenario("the centre is killed while idle")) {
            RunningProgram center = scenario.center();
            RunningProgram robot = scenario.robot("empty.map");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            center.kill();
            phone.expect("unregistered");
            scenario.centerAgain();
            phone.expect("registered");
            robot.expect("registered");
            scenario.call(phone);
        }
    }

    @Test
    void theCentreIsKilledInACallAndTheRobotStops() throws Exception {
        try (Scenario scenario = new Scenario("the centre is killed in a call")) {
            RunningProgram center = scenario.center();
            RunningProgram robot = scenario.robot("empty.map");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press **#**900**");
            robot.expect("status", "value", "Moving");
            center.kill();
            phone.expect("released");
            phone.expect("unregistered");
            robot.expect("released");
            robot.expect("status", "value", "Stopped");
            scenario.centerAgain();
            phone.expect("registered");
            robot.expect("registered");
            scenario.call(phone);
            phone.say("press **#*#90**");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");
        }
    }

    @Test
    void thePhoneIsKilledInACallAndTheRobotIsFreeForTheNext() throws Exception {
        try (Scenario scenario = new Scenario("the phone is killed in a call")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press **#**900**");
            robot.expect("status", "value", "Moving");
            phone.kill();
            robot.expect("released");
            robot.expect("status", "value", "Stopped");
            scenario.call(scenario.phone(Scenario.PHONE));
        }
    }

    @Test
    void aPhoneThatStartsBeforeTheCentreSaysSoAndRegistersLater() throws Exception {
        try (Scenario scenario = new Scenario("phone first")) {
            RunningProgram center = scenario.center();
            center.kill();
            RunningProgram phone = scenario.unregisteredPhone(Scenario.PHONE);
            phone.expect("unregistered");
            scenario.centerAgain();
            phone.expect("registered", "number", Scenario.PHONE);
        }
    }

    @Test
    void anotherPhoneCannotTakeANumberWhoseLinkLives() throws Exception {
        try (Scenario scenario = new Scenario("one number, two phones")) {
            scenario.center();
            RunningProgram first = scenario.phone(Scenario.PHONE);
            RunningProgram second = scenario.unregisteredPhone(Scenario.PHONE);
            second.expect("unregistered", "cause", "3");
            first.say("sms " + Scenario.PHONE + " note to self");
            first.expect("sms", "from", Scenario.PHONE, "text", "note to self");
            assertEquals(0, first.quit());
            second.expect("registered", "number", Scenario.PHONE);
        }
    }

    @Test
    void theEndOfInputEndsThePhoneInOrder() throws Exception {
        try (Scenario scenario = new Scenario("end of input")) {
            RunningProgram center = scenario.center();
            scenario.robot("empty.map", "--speed", "10");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press **#*#5**");
            phone.endInput();
            phone.expect("sent", "keys", "**#*#5**");
            assertEquals(0, phone.awaitExit());
            center.expect("detached", "number", Scenario.PHONE);
            assertTrue(phone.toString().contains("released cause=16"), phone.toString());
        }
    }
}
