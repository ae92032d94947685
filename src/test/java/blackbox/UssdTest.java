package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** Service codes: own number, a robot's status, a menu, and what the network refuses. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
public class UssdTest {
    private Scenario scenario;
    private RunningProgram center;
    private RunningProgram robot;
    private RunningProgram alice;
    private RunningProgram bob;

    @BeforeAll
    void twoPhonesAndARobot() {
        scenario = new Scenario("service codes");
        center = scenario.center();
        robot = scenario.robot("empty.map");
        alice = scenario.phone(Scenario.PHONE);
        bob = scenario.phone("5550101");
    }

    @AfterAll
    void end() throws Exception {
        scenario.close();
    }

    /** Asks for everything that there is, and for something that there is not. */
    public static void session(RunningProgram phone) {
        phone.say("ussd *100#").expect("ussd", "text", Scenario.PHONE);
        phone.say("ussd *200*" + Scenario.ROBOT + "#").expect("ussd");
        phone.say("ussd *111#").expect("ussd", "reply", "expected");
        phone.say("ussd 1").expect("ussd", "text", "Your number is " + Scenario.PHONE + ".");
        phone.say("ussd **61*5550299#").expect("service", "code", "61", "state", "active", "to", "5550299");
        phone.say("ussd *#61#").expect("service", "state", "active", "to", "5550299");
        phone.say("ussd #61#").expect("service", "state", "registered");
        phone.say("ussd ##002#").expect("service", "code", "002", "state", "inactive");
        phone.say("ussd *#61#").expect("service", "state", "inactive");
        phone.say("ussd *43#").expect("service", "code", "43", "state", "active");
        phone.say("ussd *#43#").expect("service", "code", "43", "state", "active");
        phone.say("ussd #43#").expect("service", "code", "43", "state", "inactive");
        phone.say("ussd *#30#").expect("service", "code", "30", "state", "active");
        phone.say("ussd *#31#").expect("service", "code", "31", "state", "inactive");
        phone.say("ussd *31#").expect("ussd-failed", "cause", "16");
        phone.say("ussd *21#").expect("ussd-failed", "cause", "17");
        phone.say("ussd *#33#").expect("ussd-failed", "cause", "21");
        phone.say("ussd *999#").expect("ussd-failed", "cause", "36");
    }

    @Test
    void thePhoneTellsItsUsersNameAtEachRegistrationAndResultsOfLessons() {
        RunningProgram phone = scenario.phone("5550105");
        phone.say("name \"\"").expect("error", "text", "name: expected name TEXT, found nothing after it");
        phone.say("name " + "\u00f1\u0151".repeat(40)).expect("error");
        phone.say("power off").expect("unregistered");
        phone.say("name  Mar\u00eda Jos\u00e9 *#\"3\"  ");
        for (int i = 0; i < 2; i++) {
            phone.say("power on").expect("ussd", "text", "Hello, Mar\u00eda Jos\u00e9 *#\"3\".");
            center.expect("named", "number", "5550105", "name", "Mar\u00eda Jos\u00e9 *#\"3\"");
            phone.say("power off").expect("unregistered");
        }
        phone.say("power on").expect("ussd");
        phone.say("ussd *300#").expect("ussd", "reply", "expected");
        phone.say("ussd =1+" + "x".repeat(40)).expect("ussd");
        center.expect("named", "number", "5550105", "name", "=1+" + "x".repeat(27));
        phone.say("ussd *301*twelve-keys*key1*pass*2*1#").expect("ussd", "text", "twelve-keys, key1: done.");
        center.expect(
                "lesson-result",
                "number",
                "5550105",
                "lesson",
                "twelve-keys",
                "step",
                "key1",
                "result",
                "pass",
                "tries",
                "2",
                "hints",
                "1");
        phone.say("ussd *301*no-such*zzz*pass*1*0#").expect("ussd", "text", "There is no such lesson or step.");
        phone.say("ussd *301*twelve-keys*key1*perhaps*2*1#").expect("ussd-failed", "cause", "36");
        phone.say("ussd *300* #").expect("ussd-failed", "cause", "36");
    }

    @Test
    void thePhoneTellsItsOwnIdentity() {
        RunningProgram phone = scenario.phone("5550102", "--imei", "490154203237518");
        phone.say("ussd *#06#").expect("imei", "number", "490154203237518");
    }

    /** TS 22.030: what the keys and the green key do, the console's dial does. */
    @Test
    void aCodeThatIsDialledIsSentAsOneThatIsTyped() {
        RunningProgram phone = scenario.phone("5550103", "--imei", "490154203237518");
        phone.say("dial *#06#").expect("imei", "number", "490154203237518");
        phone.say("dial *100#").expect("ussd", "text", "5550103");
        phone.say("dial *#43#").expect("service", "code", "43");
        phone.say("dial *31#" + Scenario.ROBOT).expect("calling", "number", Scenario.ROBOT);
        phone.say("hangup").expect("released");
        phone.say("dial #31#" + Scenario.ROBOT).expect("calling", "number", Scenario.ROBOT);
        phone.say("hangup").expect("released");
        phone.say("dial *31#abc").expect("error");
    }

    @Test
    void aSubscriberGetsItsOwnNumber() {
        alice.say("ussd *100#").expect("ussd", "text", Scenario.PHONE);
        bob.say("ussd *100#").expect("ussd", "text", "5550101");
    }

    @Test
    void aRobotTellsItsStatusAndPose() {
        robot.say("place 1.5 2 90").expect("pose");
        String stopped =
                alice.say("ussd *200*" + Scenario.ROBOT + "#").expect("ussd").field("text");
        assertEquals("Stopped at 1.500 2.000 m, heading 90.0.", stopped);

        robot.say("power off").expect("status", "value", "Disconnected");
        String off =
                alice.say("ussd *200*" + Scenario.ROBOT + "#").expect("ussd").field("text");
        assertTrue(off.startsWith("Disconnected"), off);
        robot.say("power on").say("motors on").expect("status", "value", "Stopped");
    }

    @Test
    void theQuestionMovesNothingAndDisturbsNoCall() {
        scenario.call(alice);
        bob.say("ussd *200*" + Scenario.ROBOT + "#").expect("ussd");
        alice.say("press ** #**20 **").expect("tone", "key", "3");
        alice.say("hangup").expect("released");
    }

    @Test
    void aMenuIsASession() {
        alice.say("ussd *111#").expect("ussd", "reply", "expected");
        alice.say("ussd 2").expect("ussd", "reply", "expected");
        String status = alice.say("ussd " + Scenario.ROBOT).expect("ussd").field("text");
        assertTrue(status.contains(" m, heading "), status);
    }

    @Test
    void aPhonesUserIsAskedAndAnswersInPerson() {
        alice.say("ussd *200*5550101#");
        bob.expect("ussd", "reply", "expected");
        bob.say("ussd at the desk");
        alice.expect("ussd", "text", "at the desk");
    }

    @Test
    void anUnassignedNumberIsAbsent() {
        String text = alice.say("ussd *200*5559999#").expect("ussd").field("text");
        assertTrue(text.startsWith("5559999 is not registered"), text);
    }

    @Test
    void aCodeThatIsUnknownAndAServiceThatIsNotOfferedAreRefusedByTheStandardsErrors() {
        alice.say("ussd *999#").expect("ussd-failed", "cause", "36", "text", "unexpected data value");
        alice.say("ussd *#33#").expect("ussd-failed", "cause", "21", "text", "facility not supported");
    }

    @Test
    void hangupEndsADialogueAndAnotherOneBegins() {
        alice.say("ussd *111#").expect("ussd", "reply", "expected");
        alice.say("hangup").expect("ussd-failed", "text", "cancelled");
        alice.say("ussd *100#").expect("ussd", "text", Scenario.PHONE);
    }

    @Test
    void aPhoneThatIsOffOrHasNothingToSendSaysSo() {
        bob.say("power off").expect("unregistered");
        bob.say("ussd *100#").expect("error");
        bob.say("power on").expect("registered");
        bob.say("ussd").expect("error");
    }

    @Test
    void theTextIsInTheCentresLanguage() throws Exception {
        try (Scenario spanish = new Scenario("service codes in Spanish")) {
            spanish.center("--lang", "es");
            RunningProgram phone = spanish.phone(Scenario.PHONE);
            String text = phone.say("ussd *200*5559999#").expect("ussd").field("text");
            assertEquals("5559999 no esta registrado o no responde.", text);
        }
    }
}
