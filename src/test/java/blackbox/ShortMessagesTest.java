package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** Short messages between phones: delivered, kept for the absent, never damaged. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ShortMessagesTest {
    private Scenario scenario;
    private RunningProgram center;
    private RunningProgram alice;
    private RunningProgram bob;

    @BeforeAll
    void twoPhones() {
        scenario = new Scenario("short messages");
        center = scenario.center();
        alice = scenario.phone("5550100");
        bob = scenario.phone("5550101");
    }

    @AfterAll
    void end() throws Exception {
        scenario.close();
    }

    private void send(String written, String read) {
        alice.say("sms 5550101 " + written);
        alice.expect("sms-sent", "to", "5550101");
        assertEquals(read, bob.expect("sms", "from", "5550100").field("text"));
    }

    @Test
    void plainNationalQuotedAndLongTextsArriveAsTheyWere() {
        send("hello world", "hello world");
        send("¿Dónde está el ñandú? €5 {ok}", "¿Dónde está el ñandú? €5 {ok}");
        send("日本 🤖 robot", "日本 🤖 robot");
        send("\"two\\nlines \\\"quoted\\\"\"", "two\nlines \"quoted\"");
        String longText = "abcdefghi ".repeat(50).strip();
        send(longText, longText);
        String longNational = "ж".repeat(200);
        send(longNational, longNational);
    }

    @Test
    void aMessageToAnAbsentRobotIsKeptAndDeliveredWhenItAppears() {
        alice.say("sms " + Scenario.ROBOT + " ** #**20 **");
        alice.expect("sms-sent", "to", Scenario.ROBOT);
        center.expect("sms", "to", Scenario.ROBOT, "state", "accepted");
        RunningProgram robot = scenario.robot("empty.map", "--speed", "10");
        robot.expect("sms", "from", "5550100", "text", "** #**20 **");
        alice.expect("sms", "from", Scenario.ROBOT, "text", "3 Done: #**20. Stopped at 0.200 0.000 m, heading 0.0.");
        center.expect("sms", "to", Scenario.ROBOT, "state", "delivered");
        robot.close();
    }

    @Test
    void messagesToOneReceiverKeepTheirOrder() {
        bob.say("power off").expect("unregistered");
        for (int i = 1; i <= 5; i++) {
            alice.say("sms 5550101 number " + i);
            alice.expect("sms-sent");
        }
        bob.say("power on").expect("registered");
        for (int i = 1; i <= 5; i++) {
            assertEquals("number " + i, bob.expect("sms", "from", "5550100").field("text"));
        }
    }

    @Test
    void aBroadcastReachesEveryPhone() {
        center.say("broadcast 50 Class begins at nine");
        for (RunningProgram phone : new RunningProgram[] {alice, bob}) {
            assertEquals(
                    "Class begins at nine",
                    phone.expect("broadcast", "channel", "50").field("text"));
        }
    }
}
