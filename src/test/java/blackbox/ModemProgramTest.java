package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** {@code --modem} and {@code --modem-check} with an emulated SIM800 over TCP, and with the port of our own phone. */
class ModemProgramTest {
    private static RunningProgram robotBehind(Scenario scenario, String modem, String... options) {
        String[] first = {
            "--headless",
            "--no-sound",
            "--lang=en",
            "--answer-after=0",
            "--world=" + Scenario.world("empty.map"),
            "--modem=" + modem
        };
        String[] all = Arrays.copyOf(first, first.length + options.length);
        System.arraycopy(options, 0, all, first.length, options.length);
        return scenario.start("robot", "simrobot", all);
    }

    private static Map<String, ConsoleEvent> check(String address, int status) throws Exception {
        FinishedProgram run = FinishedProgram.run("simrobot", "--modem-check", address);
        assertEquals(status, run.status(), run.output() + run.error());
        return run.output()
                .lines()
                .map(ConsoleEvent::parse)
                .collect(Collectors.toMap(event -> event.field("command"), event -> event, (first, second) -> second));
    }

    @Test
    void theCheckOfAModemThatCanServeSaysSoCommandByCommand() throws Exception {
        try (ServedModem modem = new ServedModem()) {
            Map<String, ConsoleEvent> checks = check(modem.address(), 0);
            assertEquals(
                    Map.of("command", "AT", "answer", "OK", "verdict", "ok"),
                    checks.get("AT").fields());
            assertEquals("+CPIN: READY OK", checks.get("AT+CPIN?").field("answer"));
            assertEquals("ok", checks.get("AT+DDET=1,0,1").field("verdict"));
            assertEquals("missing", checks.get("AT+CVHU=0").field("verdict"));
            assertEquals("+CREG: 1,1 OK", checks.get("AT+CREG?").field("answer"));
        }
    }

    @Test
    void theCheckNamesWhatIsMissingOrUnexpected() throws Exception {
        try (ServedModem modem = new ServedModem()) {
            modem.happens(there -> there.deaf = true);
            Map<String, ConsoleEvent> checks = check(modem.address(), 1);
            for (String enabler : List.of("AT+DDET=1", "AT#DTMF=1", "AT+QTONEDET=1", "AT+UDTMFD=1,2")) {
                assertEquals("missing", checks.get(enabler).field("verdict"));
            }
        }
        try (ServedModem modem = new ServedModem()) {
            modem.happens(there -> there.intervalStuck = true);
            Map<String, ConsoleEvent> checks = check(modem.address(), 1);
            assertEquals("unexpected", checks.get("AT+DDET?").field("verdict"));
            assertEquals("+DDET: 1,1000,0,0 OK", checks.get("AT+DDET?").field("answer"));
        }
    }

    @Test
    void aCheckWithoutAModemSaysWhy() throws Exception {
        Map<String, ConsoleEvent> checks = check("127.0.0.1:1", 1);
        assertEquals(Set.of("open"), checks.keySet());
        assertEquals("missing", checks.get("open").field("verdict"));
    }

    @Test
    void optionsThatBelongToM2AreRefused() throws Exception {
        for (String option : List.of("--codec=gsm", "--center=127.0.0.1:3003", "--record-audio=x.wav", "--at=0")) {
            FinishedProgram refused = FinishedProgram.run("simrobot", "--headless", "--modem=127.0.0.1:1", option);
            assertEquals(2, refused.status(), refused.error());
            assertTrue(refused.error().contains("--modem"), refused.error());
        }
        assertEquals(2, FinishedProgram.run("simrobot", "--modem=/dev/nothing").status());
        assertEquals(
                2,
                FinishedProgram.run("simrobot", "--headless", "--modem=127.0.0.1:1", "--robot=a=1", "--robot=b=2")
                        .status());
    }

    @Test
    void theRobotIsDrivenThroughTheModemAndStopsWhenItVanishes() throws Exception {
        try (Scenario scenario = new Scenario("a real modem");
                ServedModem modem = new ServedModem()) {
            RunningProgram robot = robotBehind(scenario, modem.address());
            robot.expect("registered", "number", Scenario.ROBOT);
            robot.expect("modem", "state", "ready");
            modem.call(Scenario.PHONE);
            robot.expect("ringing", "from", Scenario.PHONE);
            robot.expect("call", "from", Scenario.PHONE);
            robot.expect("tone", "key", "1");
            modem.press("** #**20 **");
            robot.expect("order", "verdict", "accepted");
            robot.expect("tone", "key", "6");
            robot.expect("tone", "key", "3");
            modem.press("** #**900 **");
            robot.expect("status", "value", "Moving");
            scenario.tell("the modem is unplugged");
            modem.unplug();
            robot.expect("modem", "state", "silent");
            robot.expectBefore(Set.of("status"), "released", "cause", "41");
            // The robot brakes while the modem is taken off the network: their events come in either order.
            robot.expect("status", "value", "Stopped");
            modem.plugIn();
            robot.expect("registered");
            robot.said("unregistered");
            robot.say("modem").expect("modem", "state", "ready");
            scenario.tell("an order by SMS");
            modem.message(Scenario.PHONE, "** #*#90 **");
            robot.expect("sms", "from", Scenario.PHONE);
            robot.expect("reply", "to", Scenario.PHONE);
            assertEquals("163", modem.tonesSent().substring(0, 3));
            assertEquals(0, robot.quit());
        }
    }

    @Test
    void thePortOfOurOwnPhoneServesAsAModem() throws Exception {
        try (Scenario scenario = new Scenario("our phone as the robot's modem")) {
            scenario.center();
            RunningProgram modem = scenario.start(
                    "modem",
                    "simgsm-phone",
                    "--headless",
                    "--no-sound",
                    "--center=" + scenario.centerAddress(),
                    "--number=" + Scenario.ROBOT,
                    "--at=0");
            String address = "127.0.0.1:" + modem.expect("ready").field("at");
            modem.expect("registered");
            check(address, 0);
            RunningProgram robot = robotBehind(scenario, address);
            robot.expect("registered", "number", Scenario.ROBOT);
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            robot.expect("call", "from", Scenario.PHONE);
            phone.say("press ** #**20 **");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");
            robot.expect("outcome", "tone", "3");
            phone.say("press ** #**0 **");
            phone.expectNext("tone", "key", "7");
            phone.say("hangup").expect("released", "cause", "16");
            robot.expect("released", "cause", "16");
            phone.say("sms " + Scenario.ROBOT + " ** #*#90 **");
            assertTrue(phone.expect("sms").field("text").startsWith("3 Done: #*#90."));
            scenario.tell("a motion ends with its call");
            scenario.call(phone);
            phone.say("press ** #**500 **");
            phone.expectNext("tone", "key", "6");
            robot.expect("order", "text", "**#**500**");
            robot.expect("status", "value", "Moving");
            phone.say("hangup").expect("released", "cause", "16");
            robot.expectBefore(Set.of("status"), "released");
            robot.expect("status", "value", "Stopped");
            scenario.tell("and the robot's end with the phone's");
            modem.quit();
            robot.expect("unregistered");
            assertEquals(0, robot.quit());
        }
    }
}
