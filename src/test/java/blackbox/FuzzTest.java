package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Spoilt traffic does a running centre no harm. */
class FuzzTest {
    @Test
    void aCentreThatReceivedNonsenseServesAPhoneAsBefore() throws Exception {
        try (Scenario scenario = new Scenario("spoilt dialogues")) {
            RunningProgram center = scenario.center("--log-level", "off");
            FinishedProgram fuzz = FinishedProgram.run(
                    "simgsm-modem", "fuzz", "--frames", "10000", "--seed", "1", "--center", scenario.centerAddress());
            assertEquals(0, fuzz.status(), fuzz.error());
            ConsoleEvent line = ConsoleEvent.parse(fuzz.output().strip());
            assertEquals("fuzz", line.name());
            assertTrue(Long.parseLong(line.field("frames")) >= 10_000, fuzz.output());
            scenario.tell("a well-behaved phone afterwards");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            phone.say("sms " + Scenario.PHONE + " still there?");
            phone.expect("sms", "text", "still there?");
            assertEquals(0, phone.quit());
            assertEquals(0, center.quit());
        }
    }

    @Test
    void theDecodersReadOrRefuseEverything() throws Exception {
        FinishedProgram fuzz = FinishedProgram.run("simgsm-modem", "fuzz", "--frames", "20000", "--seed", "2");
        assertEquals(0, fuzz.status(), fuzz.error());
        ConsoleEvent line = ConsoleEvent.parse(fuzz.output().strip());
        assertEquals("20000", line.field("frames"));
        assertEquals("2", line.field("seed"));
    }
}
