package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** 112 and 911: with and without registration, over a terminal's own link and over towers, answered or not. */
class EmergencyCallTest {
    private static final String CARD = "sim number=5550100 imsi=001010005550100 k=465b5ce8b199b49faa5f0a2ee238a6bc"
            + " algorithm=comp128v2 pin=1234 puk=12345678\nsim number=5550200 imsi=001010005550200"
            + " k=00112233445566778899aabbccddeeff algorithm=comp128v3\n";

    @TempDir
    Path cards;

    @Test
    void withoutAReceiverTheNetworkPlaysANoticeAndClears() throws Exception {
        try (Scenario scenario = new Scenario("112 without --emergency")) {
            RunningProgram center = scenario.center();
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            phone.say("dial 112");
            assertEquals("emergency", phone.expect("calling", "number", "112").field("service"));
            phone.expect("connected", "number", "112");
            center.expect("call", "from", Scenario.PHONE, "to", "112", "state", "active");
            phone.expect("released", "cause", "16");
            center.expect("call", "to", "112", "state", "released");
            assertTrue(center.log().contains("emergency call, answered by a notice"), center.log());
            scenario.tell("afterwards the phone calls as ever");
            phone.say("dial 5559999");
            phone.expect("released", "cause", "1");
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aLockedCardCallsWhoAnswersEmergencies(boolean overTowers) throws Exception {
        String list = Files.writeString(cards.resolve("class.hlr"), CARD).toString();
        try (Scenario scenario = new Scenario("911 without a PIN, over towers: " + overTowers)) {
            RunningProgram center = scenario.center("--hlr", list, "--emergency", Scenario.ROBOT);
            Optional<RunningProgram> cells = overTowers ? Optional.of(scenario.cells("avenue.town")) : Optional.empty();
            RunningProgram robot = scenario.robot("empty.map", "--sim", list);
            RunningProgram phone =
                    scenario.unregisteredPhone(Scenario.PHONE, "--sim", list, "--imei", "490154203237518");
            phone.expect("sim", "state", "pin");
            phone.say("dial 911");
            phone.expectBefore(Set.of("registered"), "connected", "number", Scenario.ROBOT);
            if (cells.isPresent()) {
                cells.get().say("mobiles");
                cells.get().expect("mobile", "number", "IMEI-490154203237518");
            }
            String caller = robot.expect("call").field("from");
            assertTrue(caller.matches("911[0-9]{7}"), caller);
            phone.expect("tone", "key", "1");
            phone.say("press **#**10**");
            phone.expect("tone", "key", "6");
            center.expect("call", "from", caller, "to", "112", "state", "active");
            phone.say("pin 1234");
            phone.expect("sim", "state", "ready");
            phone.expect("tone", "key", "3");
            phone.say("hangup");
            robot.expect("released", "cause", "16");
            scenario.tell("the card has its PIN meanwhile: the phone registers after the call");
            phone.expect("registered", "number", Scenario.PHONE);
            phone.say("dial 112");
            robot.expect("call", "from", Scenario.PHONE);
            phone.say("hangup");
        }
    }
}
