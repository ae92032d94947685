package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** A centre with --country-code 34: numbers with and without it, at consoles and AT port. */
class CountryCodeTest {
    private static final String OTHER = "5550101";
    private static final String THIRD = "5550102";

    @Test
    void aSubscriberIsReachedInBothFormsAndShownInTheInternationalOne() throws Exception {
        try (Scenario scenario = new Scenario("numbers of one country")) {
            scenario.center("--country-code", "34");
            RunningProgram caller = scenario.phone(Scenario.PHONE, "--at", "0");
            RunningProgram called = scenario.phone(OTHER);
            for (String number : new String[] {"+34" + OTHER, OTHER}) {
                caller.say("dial " + number);
                called.expectNext("ringing", "from", "+34" + Scenario.PHONE);
                called.say("answer");
                caller.expectNext("connected", "number", "+34" + OTHER);
                caller.say("hangup");
                called.expectNext("released");
                caller.say("sms " + number + " hello");
                called.expectNext("sms", "from", "+34" + Scenario.PHONE);
            }
            caller.say("dial +44" + OTHER);
            caller.expectNext("calling", "number", "+44" + OTHER);
            caller.expectNext("released", "cause", "1");
            try (AtPortClient port = AtPortClient.connect(caller)) {
                assertEquals("OK", port.ask("ATD+34" + OTHER + ";"));
                called.expectNext("ringing", "from", "+34" + Scenario.PHONE);
                assertEquals("OK", port.ask("ATH"));
                called.expectNext("released");
                assertEquals("OK", port.ask("AT+CLIP=1"));
                called.say("dial +34" + Scenario.PHONE);
                assertEquals("RING", port.next());
                assertEquals("+CLIP: \"+34" + OTHER + "\",145", port.next().replaceAll(",,.*", ""));
            }
        }
    }

    @Test
    void aRobotAnswersAnOrderBySmsToTheNumberThatItWasShown() throws Exception {
        try (Scenario scenario = new Scenario("an order by SMS in a country")) {
            scenario.center("--country-code", "34");
            RunningProgram caller = scenario.phone(Scenario.PHONE);
            scenario.robot("empty.map", "--operators", "+34" + Scenario.PHONE);
            caller.say("sms +34" + Scenario.ROBOT + " **#**10**");
            assertTrue(caller.expect("sms", "from", "+34" + Scenario.ROBOT)
                    .field("text")
                    .startsWith("3 Done"));
        }
    }

    @Test
    void aForwardingToAnInternationalNumberReachesTheSubscriber() throws Exception {
        try (Scenario scenario = new Scenario("a forwarding in a country")) {
            scenario.center("--country-code", "34");
            RunningProgram caller = scenario.phone(Scenario.PHONE);
            RunningProgram forwarding = scenario.phone(OTHER);
            RunningProgram receiver = scenario.phone(THIRD);
            forwarding.say("dial **21*+34" + THIRD + "#");
            forwarding.expect("service", "state", "active");
            caller.say("dial " + OTHER);
            receiver.expect("forwarded-by", "number", "+34" + OTHER);
        }
    }

    @Test
    void aWrongCodeIsRefusedWithWhatWasExpected() throws Exception {
        try (Scenario scenario = new Scenario("a wrong country code")) {
            RunningProgram center =
                    scenario.start("center", "simgsm-center", "--headless", "--lang", "en", "--country-code", "+34");
            assertEquals(2, center.awaitExit());
            assertTrue(center.log().contains("\"+34\" is not a country code of 1 to 3 digits"), center.log());
        }
    }
}
