package blackbox.fuzz;

import static org.junit.jupiter.api.Assertions.assertEquals;

import blackbox.RunningProgram;
import blackbox.Scenario;
import java.net.InetSocketAddress;
import org.junit.jupiter.api.Test;

class CenterFuzzTest {
    @Test
    void aCentreThatReceivedMutatedDialoguesServesAPhoneAsBefore() throws Exception {
        try (Scenario scenario = new Scenario("mutated dialogues")) {
            RunningProgram center = scenario.center("--log-level", "off");
            String address = scenario.centerAddress();
            int port = Integer.parseInt(address.substring(address.indexOf(':') + 1));
            new CenterFuzz(new InetSocketAddress("127.0.0.1", port), Long.getLong("fuzz.first", 1))
                    .run(LongRun.frames(10_000));
            scenario.tell("an intact phone afterwards");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            phone.say("sms " + Scenario.PHONE + " still there?");
            phone.expect("sms", "text", "still there?");
            assertEquals(0, phone.quit());
            assertEquals(0, center.quit());
        }
    }
}
