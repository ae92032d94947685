package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Cards of all algorithms in a closed network, and their PIN and PUK at console and AT port. */
class SimPinTest {
    private static final String PUK = "12345678";

    @TempDir
    Path cards;

    /** A list of one phone and one robot. */
    private String list(String algorithm, String pin) throws IOException {
        Path file = cards.resolve("class.hlr");
        String keys = "k=465b5ce8b199b49faa5f0a2ee238a6bc "
                + (algorithm.equals("milenage") ? "opc=cd63cb71954a9f4e48a5994e37a02baf" : "algorithm=" + algorithm);
        Files.writeString(
                file,
                "sim number=%s imsi=001010005550100 %s %s # the phone\nsim number=%s imsi=001010005550200 %s %s\n"
                        .formatted(Scenario.PHONE, keys, pin, Scenario.ROBOT, keys, pin));
        return file.toString();
    }

    @ParameterizedTest
    @ValueSource(strings = {"milenage", "comp128v1", "comp128v2", "comp128v3"})
    void aCardOfEachAlgorithmRegistersInAClosedNetwork(String algorithm) throws Exception {
        String list = list(algorithm, "");
        try (Scenario scenario = new Scenario("a card with " + algorithm)) {
            scenario.center("--hlr", list);
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--sim", list);
            phone.say("dial 5559999");
            phone.expect("released", "cause", "1");
        }
    }

    @Test
    void threeWrongPinsAskForThePukAndARestartGivesNoNewTries() throws Exception {
        String list = list("comp128v1", "pin=1234 puk=" + PUK);
        try (Scenario scenario = new Scenario("PIN and PUK at the console")) {
            scenario.center("--hlr", list);
            RunningProgram phone = scenario.unregisteredPhone(Scenario.PHONE, "--sim", list);
            phone.expect("sim", "state", "pin", "tries", "3");
            phone.say("dial 5559999");
            phone.expect(
                    "error", "text", "dial: the SIM is locked; only emergency numbers, such as 112, can be called");
            phone.say("pin 12");
            phone.expect("error", "text", "pin: expected a PIN of 4 to 8 digits");
            phone.say("pin 0000");
            phone.expectBefore(Set.of("registered"), "sim", "state", "pin", "tries", "2");
            scenario.tell("killed and started again: one try is gone");
            phone.kill();
            phone = scenario.unregisteredPhone(Scenario.PHONE, "--sim", list);
            phone.expect("sim", "state", "pin", "tries", "2");
            phone.say("pin 1111");
            phone.expect("sim", "state", "pin", "tries", "1");
            phone.say("dial **04*1111*2222*2222#");
            phone.expect("sim", "state", "puk", "tries", "10");
            phone.say("pin 1234");
            phone.expect("error");
            phone.say("puk 00000000 4321");
            phone.expect("sim", "state", "puk", "tries", "9");
            phone.say("dial **05*" + PUK + "*4321*4321#");
            phone.expectBefore(Set.of("registered"), "sim", "state", "ready", "tries", "3");
            phone.expect("registered", "number", Scenario.PHONE);
            phone.say("dial **04*4321*999999*999999#");
            phone.say("power off");
            phone.expect("unregistered");
            phone.say("power on");
            phone.expect("sim", "state", "pin", "tries", "3");
            phone.say("pin 999999");
            phone.expect("registered");
            assertEquals(0, phone.quit());
        }
        String kept = Files.readString(cards.resolve("class.hlr"));
        assertTrue(
                kept.contains(" pin=999999 puk=12345678 pin-enabled=true pin-tries=3 puk-tries=10 # the phone\n"),
                kept);
        assertTrue(kept.endsWith("pin=1234 puk=12345678\n"), kept);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theAtPortAsksForThePinAndChangesIt(boolean isRobot) throws Exception {
        String list = list("milenage", "pin=1234 puk=" + PUK);
        try (Scenario scenario = new Scenario("PIN at the AT port")) {
            scenario.center("--hlr", list);
            RunningProgram program = isRobot
                    ? scenario.unregisteredRobot("empty.map", "--sim", list, "--at", "0")
                    : scenario.unregisteredPhone(Scenario.PHONE, "--sim", list, "--at", "0");
            try (AtPortClient port = AtPortClient.connect(program)) {
                String[][] dialogue = {
                    {"AT+CMEE=1", "OK"},
                    {"AT+CPIN?", "+CPIN: SIM PIN|OK"},
                    {"AT+CIMI", "+CME ERROR: 11"},
                    {"ATD5550200;", "+CME ERROR: 11"},
                    {"AT+CLCK=\"SC\",2", "+CLCK: 1|OK"},
                    {"AT+CPIN=\"0000\"", "+CME ERROR: 16"},
                    {"AT+CPINR", "+CPINR: SIM PIN,2,3|+CPINR: SIM PUK,10,10|OK"},
                    {"AT+CPIN=\"1234\"", "OK"},
                    {"AT+CFUN=1", "OK"},
                    {"AT+CPIN?", "+CPIN: READY|OK"},
                    {"AT+CPWD=\"SC\",\"1234\",\"5678\"", "OK"},
                    {"AT+CLCK=\"SC\",0,\"1234\"", "+CME ERROR: 16"},
                    {"ATD**04*5678*1234*1234#;", "OK"},
                    {"AT+CUSD=1,\"**04*0000*1234*1234#\"", "+CME ERROR: 16"},
                    {"AT+CLCK=\"SC\",0,\"1234\"", "OK"},
                    {"AT+CLCK=\"SC\",2", "+CLCK: 0|OK"},
                    {"AT+CPWD=\"SC\",\"1234\",\"5678\"", "+CME ERROR: 3"},
                    {"AT+CLCK=\"SC\",1,\"0000\"", "+CME ERROR: 16"},
                    {"AT+CLCK=\"SC\",1,\"0000\"", "+CME ERROR: 16"},
                    {"AT+CLCK=\"SC\",1,\"0000\"", "+CME ERROR: 12"},
                    {"AT+CPIN?", "+CPIN: SIM PUK|OK"},
                    {"AT+CPIN=\"12345678\",\"1234\"", "OK"},
                    {"AT+SPIC", "+SPIC: 3,10,3,10|OK"},
                };
                for (String[] step : dialogue) {
                    assertEquals(step[1], port.ask(step[0]), step[0]);
                }
            }
            program.expect("registered");
        }
    }

    @Test
    void aRobotBehindAModemThatAsksForAPinSaysSoAndEntersItFromItsFileOnce() throws Exception {
        String list = list("milenage", "pin=1234 puk=" + PUK);
        Path wrong = Files.writeString(cards.resolve("wrong"), "0000\n");
        Path right = Files.writeString(cards.resolve("right"), "1234\n");
        try (Scenario scenario = new Scenario("--pin-file")) {
            scenario.center("--hlr", list);
            RunningProgram phone = scenario.unregisteredPhone(Scenario.PHONE, "--sim", list, "--at", "0");
            phone.expect("sim", "state", "pin", "tries", "3");
            RunningProgram robot = behind(scenario, phone, wrong);
            robot.expect("modem", "state", "sim-pin");
            phone.expect("sim", "state", "pin", "tries", "2");
            scenario.tell("started again: now 2 tries are left, so the PIN is tried, and after that never again");
            robot.kill();
            robot = behind(scenario, phone, wrong);
            phone.expect("sim", "state", "pin", "tries", "1");
            robot.kill();
            robot = behind(scenario, phone, right);
            robot.expect("modem", "state", "sim-pin");
            robot.say("wait modem state=ready 3");
            robot.expect("error");
            phone.say("pin 1234");
            robot.expect("modem", "state", "ready");
        }
    }

    private static RunningProgram behind(Scenario scenario, RunningProgram phone, Path pin) {
        return scenario.start(
                "robot",
                "simrobot",
                "--headless",
                "--world",
                Scenario.world("empty.map").toString(),
                "--modem",
                "127.0.0.1:" + phone.said("ready").field("at"),
                "--pin-file",
                pin.toString());
    }

    @Test
    void aSimulatedModemTakesItsPinFromTheFileToo() throws Exception {
        String list = list("comp128v3", "pin=1234 puk=" + PUK);
        Path right = Files.writeString(cards.resolve("right"), "1234\n");
        try (Scenario scenario = new Scenario("--pin-file for M2")) {
            scenario.center("--hlr", list);
            scenario.robot("empty.map", "--sim", list, "--pin-file", right.toString());
        }
    }
}
