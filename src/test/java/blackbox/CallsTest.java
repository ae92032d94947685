package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** Calls between phones and to the robot: how each can end, with the cause that TS 24.008 gives it. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class CallsTest {
    private Scenario scenario;
    private RunningProgram robot;
    private RunningProgram alice;
    private RunningProgram bob;

    @BeforeAll
    void twoPhonesAndARobot() {
        scenario = new Scenario("calls");
        scenario.center();
        robot = scenario.robot("empty.map");
        alice = scenario.phone("5550100");
        bob = scenario.phone("5550101");
    }

    @AfterAll
    void end() throws Exception {
        scenario.close();
    }

    @Test
    void aNumberWithoutASubscriberIsUnassigned() {
        alice.say("dial 999");
        ConsoleEvent released = alice.expectBefore(Set.of("alerting", "connected"), "released");
        assertEquals("1", released.field("cause"));
        assertEquals("unassigned number", released.field("text").toLowerCase());
    }

    @Test
    void aPhoneThatIsOffIsOutOfOrder() {
        bob.say("power off").expect("unregistered");
        alice.say("dial 5550101");
        alice.expect("released", "cause", "27");
        bob.say("power on").expect("registered");
    }

    @Test
    void aRejectedCallTellsTheCaller() {
        alice.say("dial 5550101");
        bob.expect("ringing", "from", "5550100");
        bob.say("hangup");
        ConsoleEvent released = alice.expectBefore(Set.of("connected"), "released");
        assertTrue(Set.of("21", "17", "16").contains(released.field("cause")), released.toString());
    }

    @Test
    void phonesTalkToOneAnotherAndHearEachOthersKeys() {
        alice.say("dial 5550101");
        alice.expect("calling", "number", "5550101");
        bob.expect("ringing", "from", "5550100");
        alice.expect("alerting");
        bob.say("answer").expect("connected", "number", "5550100");
        alice.expect("connected", "number", "5550101");
        alice.say("press 159D");
        for (String key : "159D".split("")) {
            bob.expectNext("tone", "key", key);
        }
        alice.expect("sent", "keys", "159D");
        bob.say("press 2");
        alice.expectNext("tone", "key", "2");
        bob.say("hangup").expect("released", "cause", "16");
        alice.expect("released", "cause", "16");
    }

    @Test
    void theCallerMayGiveUpWhileItRings() {
        alice.say("dial 5550101");
        bob.expect("ringing");
        alice.say("hangup").expect("released", "cause", "16");
        bob.expectBefore(Set.of("connected"), "released");
    }

    @Test
    void twoPhonesContendForTheRobotAndTheSecondHearsBusy() {
        scenario.call(alice);
        bob.say("dial " + Scenario.ROBOT);
        bob.expect("released", "cause", "17");
        alice.say("hangup").expect("released", "cause", "16");
        robot.expect("released");
        scenario.call(bob);
        bob.say("hangup").expect("released", "cause", "16");
        robot.expect("released");
    }

    @Test
    void aPhoneThatDialsItselfIsBusy() {
        alice.say("dial 5550100");
        alice.expect("released", "cause", "17");
    }

    @Test
    void hangUpWhileMovingBrakesTheRobotAndReleasedComesBeforeTheStatus() {
        scenario.call(alice);
        alice.say("press **#**500**");
        alice.expectNext("tone", "key", "6");
        robot.expect("status", "value", "Moving");
        while (robot.ask("pose", "pose").number("x") < 0.02) {
            scenario.tell("not yet two centimetres");
        }
        alice.say("hangup").expect("released", "cause", "16");
        robot.expectBefore(Set.of("status"), "released", "cause", "16");
        robot.expect("status", "value", "Stopped");
        double x = robot.ask("pose", "pose").number("x");
        assertTrue(x > 0 && x < 5, "x = " + x);

        scenario.tell("the next caller hears nothing of it");
        scenario.call(bob);
        bob.say("press **#*0**");
        bob.expectNext("tone", "key", "3");
        bob.say("hangup").expect("released");
        robot.expect("released");
    }

    @Test
    void malformedCommandsAreErrorsAndThePhoneGoesOn() {
        for (String line :
                new String[] {"dial", "dial x", "press 1", "sms", "sms 5550101", "hangup now", "bogus", "power"}) {
            alice.say(line);
            alice.expect("error");
        }
        assertEquals("inbox", alice.ask("inbox", "end").field("of"));
    }
}
