package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;

/** A network for listed SIMs alone: who comes in, who does not and why, and whom one reaches. */
class ClosedNetworkTest {
    private static final String ABSENT = "5550101";
    private static final String BARRED = "5550102";
    private static final String NOBODY = "5559999";
    private static final String STOLEN = "490154203237518";

    @TempDir
    Path cards;

    private Path list() {
        return cards.resolve("class.hlr");
    }

    private String card(String number) {
        return cards.resolve(number + ".sim").toString();
    }

    /** A phone, a robot, an absent subscriber, a barred subscriber, and a barred telephone. */
    private void makeCards() throws Exception {
        FinishedProgram made = FinishedProgram.run(
                "simgsm-center", "--hlr", list().toString(), "--new-sim", "5550100-5550102," + Scenario.ROBOT);
        assertEquals(0, made.status(), made.error());
        assertEquals(5, made.output().lines().count(), made.output());
        Files.writeString(list(), Files.readString(list()).replaceFirst("(sim number=" + BARRED + ".*)", "$1 barred"));
        Files.writeString(list(), "barred-imei " + STOLEN + "\n", StandardOpenOption.APPEND);
    }

    @Test
    void whoeverHasTheRightCardUsesTheNetworkAsEver() throws Exception {
        makeCards();
        try (Scenario scenario = new Scenario("a closed network from inside")) {
            RunningProgram center = scenario.center("--hlr", list().toString(), "--smpp", "0");
            RunningProgram robot = scenario.robot("empty.map", "--sim", card(Scenario.ROBOT), "--speed", "20");
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--sim", card(Scenario.PHONE));
            scenario.tell("the robot is driven by keys and by SMS");
            scenario.call(phone);
            phone.say("press ** #**20 **");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");
            phone.say("hangup");
            robot.expect("released");
            phone.say("sms " + Scenario.ROBOT + " ** #*#90 **");
            robot.expect("order", "verdict", "accepted");
            phone.expect("sms", "from", Scenario.ROBOT);
            scenario.tell("unassigned and barred numbers get cause 1, the number of an absent subscriber does not");
            for (String number : new String[] {NOBODY, BARRED}) {
                phone.say("sms " + number + " hello");
                phone.expect("sms-failed", "to", number, "cause", "1");
                phone.say("dial " + number);
                phone.expect("released", "cause", "1");
            }
            phone.say("dial " + ABSENT);
            phone.expect("released", "cause", "27");
            scenario.tell("the same for applications");
            try (SmppApplication application = new SmppApplication(scenario.smppPort(), "robotics", "", "5550300")) {
                IOException refused = assertThrows(IOException.class, () -> application.submit(NOBODY, "hello", false));
                assertTrue(refused.getMessage().startsWith("status 11 "), refused.getMessage());
                application.submit(Scenario.PHONE, "hello", false);
                phone.expect("sms", "from", "5550300", "text", "hello");
                phone.say("sms 5550300 and to you");
                assertEquals("and to you", application.await(false).text());
            }
            scenario.tell("a card that lies about its number is called by the network's own list");
            String card = Files.readString(Path.of(card(Scenario.PHONE)));
            assertEquals(0, phone.quit());
            center.expect("detached", "number", Scenario.PHONE);
            Path lying = Files.writeString(
                    cards.resolve("lying.sim"), card.replace("number=" + Scenario.PHONE, "number=" + ABSENT));
            RunningProgram liar = scenario.phone(ABSENT, "--sim", lying.toString());
            center.expect("attached", "number", Scenario.PHONE);
            liar.say("dial " + Scenario.ROBOT);
            robot.expect("call", "from", Scenario.PHONE);
            liar.expect("tone", "key", "1");
            liar.say("hangup");
            scenario.tell("the operator sees all cards");
            center.say("subscribers");
            center.expect("subscriber", "number", Scenario.PHONE, "state", "attached");
            center.expect("subscriber", "number", ABSENT, "state", "detached");
            center.expect("subscriber", "number", BARRED, "state", "barred");
            center.expect("end", "of", "subscribers", "count", "4");
        }
    }

    @Test
    void whoeverHasTheWrongCardStaysOutsideAndTheWireSaysWhy() throws Exception {
        makeCards();
        Path wrong = Files.writeString(
                cards.resolve("wrong.sim"),
                Files.readString(Path.of(card(Scenario.PHONE)))
                        .replaceFirst(" k=[0-9a-f]+", " k=00112233445566778899aabbccddeeff"));
        try (Scenario scenario = new Scenario("a closed network from outside")) {
            Path capture = scenario.folder().resolve("closed.pcap");
            RunningProgram center = scenario.center("--hlr", list().toString(), "--capture", capture.toString());
            refused(scenario, Scenario.PHONE, "3", "--sim", wrong.toString());
            refused(scenario, Scenario.PHONE, "3");
            refused(scenario, NOBODY, "2");
            refused(scenario, BARRED, "11", "--sim", card(BARRED));
            refused(scenario, ABSENT, "6", "--sim", card(ABSENT), "--imei", STOLEN);
            scenario.tell("the same card in another telephone is welcome");
            RunningProgram phone = scenario.phone(ABSENT, "--sim", card(ABSENT));
            center.say("subscribers");
            center.expect("subscriber", "number", Scenario.PHONE, "state", "detached");
            center.expect("subscriber", "number", ABSENT, "state", "attached");
            assertEquals(0, phone.quit());
            center.expect("detached", "number", ABSENT);
            assertEquals(0, center.quit());
            assertFalse(center.toString().contains("attached number=" + Scenario.PHONE), "it never came in");
            CaptureFile.read(capture).requireWholeFrames();
        }
    }

    private static void refused(Scenario scenario, String number, String cause, String... options) throws Exception {
        scenario.tell(number + " is refused with cause " + cause);
        RunningProgram phone = scenario.unregisteredPhone(number, options);
        phone.expectBefore(Set.of("registered"), "unregistered", "cause", cause);
        phone.say("dial " + Scenario.ROBOT);
        phone.expectBefore(Set.of("registered", "alerting"), "released", "cause", "38");
        assertEquals(0, phone.quit());
    }

    @Test
    void aListThatIsNoneIsNamedWithItsLine() throws Exception {
        Files.writeString(list(), "# our class\nsim number=5550100 imsi=001010005550100 k=12 opc=34\n");
        String data = cards.resolve("data").toString();
        for (List<String> command : List.of(
                List.of("simgsm-center", "--port=0", "--data", data, "--hlr"),
                List.of("simgsm-phone", "--sim"),
                List.of("simrobot", "--sim"))) {
            List<String> arguments = new ArrayList<>(command.subList(1, command.size()));
            arguments.addAll(List.of(list().toString(), "--headless"));
            FinishedProgram refused = FinishedProgram.run(command.get(0), arguments, Map.of());
            assertEquals(74, refused.status(), refused.error());
            String error = list() + ", line 2: expected k= with 32 hexadecimal digits, found 2 characters";
            assertTrue(refused.error().contains(error), refused.error());
            assertEquals("", refused.output());
        }
    }

    @Test
    void aFileThatIsNotThereIsAnInputOutputErrorAndACardThatIsNotInItAUsageError() throws Exception {
        makeCards();
        FinishedProgram missing = FinishedProgram.run("simgsm-phone", "--headless", "--sim", card("7"));
        assertEquals(74, missing.status(), missing.error());
        assertTrue(missing.error().contains("7.sim: no such file"), missing.error());
        FinishedProgram foreign =
                FinishedProgram.run("simgsm-phone", "--headless", "--number=7", "--sim", card(Scenario.PHONE));
        assertEquals(2, foreign.status(), foreign.error());
        assertTrue(foreign.error().contains("holds the SIM of 5550100, not that of 7"), foreign.error());
        FinishedProgram open = FinishedProgram.run("simrobot", "--headless", "--sim", list().toString());
        assertEquals(2, open.status(), open.error());
        assertTrue(open.error().contains("holds 4 SIMs"), open.error());
        FinishedProgram nowhere = FinishedProgram.run("simgsm-center", "--new-sim", "7");
        assertEquals(2, nowhere.status(), nowhere.error());
        assertTrue(nowhere.error().contains("--new-sim needs --hlr"), nowhere.error());
    }

    @Test
    @ResourceLock("port 3003")
    void theDemoNeedsTheCardsOfItsTwoParts() throws Exception {
        FinishedProgram made =
                FinishedProgram.run("simgsm-center", "--hlr", list().toString(), "--new-sim", Scenario.PHONE);
        assertEquals(0, made.status(), made.error());
        FinishedProgram demo = FinishedProgram.run("simgsm-center", "--demo", "--headless", "--hlr", list().toString());
        assertEquals(2, demo.status(), demo.error());
        assertTrue(demo.error().contains("--demo: expected SIMs of 5550100 and 5550200"), demo.error());
    }
}
