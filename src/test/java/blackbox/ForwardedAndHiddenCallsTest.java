package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.OffsetDateTime;
import org.junit.jupiter.api.Test;

/** Notifications of a forwarded call, a number hidden for one call, and the network's time. */
class ForwardedAndHiddenCallsTest {
    private static final String OTHER = "5550101";
    private static final String THIRD = "5550102";

    @Test
    void callerAndReceiverAreToldOfAForwarding() throws Exception {
        try (Scenario scenario = new Scenario("a forwarded call")) {
            scenario.center();
            RunningProgram caller = scenario.phone(Scenario.PHONE);
            RunningProgram forwarding = scenario.phone(OTHER);
            RunningProgram receiver = scenario.phone(THIRD);
            forwarding.say("dial **21*" + THIRD + "#");
            forwarding.expect("service", "state", "active");
            caller.say("dial " + OTHER);
            caller.expect("forwarded");
            receiver.expect("ringing", "from", Scenario.PHONE);
            receiver.expect("forwarded-by", "number", OTHER);
            receiver.say("answer");
            caller.expect("connected", "number", THIRD);
            caller.say("hangup");
            receiver.expect("released");
            forwarding.say("dial " + THIRD);
            forwarding.expect("forwarding-active");
            receiver.expect("ringing", "from", OTHER);
        }
    }

    @Test
    void aSubscriberWhoIsBusyIsToldThatACallIsForwarded() throws Exception {
        try (Scenario scenario = new Scenario("a call forwarded on busy")) {
            scenario.center();
            RunningProgram caller = scenario.phone(Scenario.PHONE);
            RunningProgram busy = scenario.phone(OTHER);
            RunningProgram receiver = scenario.phone(THIRD);
            RunningProgram peer = scenario.phone("5550103");
            busy.say("dial #43#");
            busy.expect("service", "code", "43");
            busy.say("dial **67*" + THIRD + "#");
            busy.expect("service", "state", "active");
            busy.say("dial 5550103");
            peer.expect("ringing");
            caller.say("dial " + OTHER);
            busy.expect("incoming-forwarded");
            receiver.expect("ringing", "from", Scenario.PHONE);
        }
    }

    @Test
    void aNumberIsHiddenForOneCallAtConsoleAndAtPort() throws Exception {
        try (Scenario scenario = new Scenario("#31# for one call")) {
            RunningProgram center = scenario.center();
            RunningProgram caller = scenario.phone(Scenario.PHONE, "--at", "0");
            RunningProgram called = scenario.phone(OTHER);
            caller.say("dial #31#" + OTHER);
            assertEquals("", called.expectNext("ringing").field("from"));
            center.expect("call", "from", Scenario.PHONE, "to", OTHER);
            caller.say("hangup");
            called.expect("released");
            try (AtPortClient port = AtPortClient.connect(caller)) {
                String[][] calls = {
                    {"ATD" + OTHER + ";", Scenario.PHONE},
                    {"ATD#31#" + OTHER + ";", ""},
                    {"ATD" + OTHER + "I;", ""},
                    {"AT+CLIR=1", null},
                    {"ATD" + OTHER + ";", ""},
                    {"ATD*31#" + OTHER + ";", Scenario.PHONE},
                    {"ATD" + OTHER + "i;", Scenario.PHONE},
                };
                for (String[] call : calls) {
                    assertEquals("OK", port.ask(call[0]), call[0]);
                    if (call[1] != null) {
                        assertEquals(call[1], called.expectNext("ringing").field("from"), call[0]);
                        assertEquals("OK", port.ask("ATH"));
                        called.expectNext("released");
                    }
                }
                assertEquals("+CLIR: 1,4|OK", port.ask("AT+CLIR?"));
            }
        }
    }

    @Test
    void thePhonesClockIsSetByTheNetwork() throws Exception {
        try (Scenario scenario = new Scenario("the network's time")) {
            scenario.center();
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--at", "0");
            OffsetDateTime time =
                    OffsetDateTime.parse(phone.expect("network-time").field("time"));
            assertTrue(Duration.between(time, OffsetDateTime.now()).abs().toMinutes() < 2, time.toString());
            assertEquals(OffsetDateTime.now().getOffset(), time.getOffset());
        }
    }
}
