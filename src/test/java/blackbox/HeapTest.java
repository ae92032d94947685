package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.junit.jupiter.api.Test;

/** A centre with a small heap refuses what it could not restore, and restores what it has accepted. */
class HeapTest {
    private static final Map<String, String> SMALL_HEAP = Map.of("JDK_JAVA_OPTIONS", "-Xmx64m");
    private static final int MESSAGE_QUEUE_FULL = 0x14;
    /** 40 parts of 153 septets. */
    private static final String LONG = "0123456789abcdefg".repeat(9 * 40);

    private static final int PARTS = 40;

    @Test
    void whatASmallHeapAcceptsTheSameHeapRestores() throws Exception {
        try (Scenario scenario = new Scenario("64 MB of heap, filled until the centre refuses, then killed")) {
            RunningProgram center = scenario.centerIn(SMALL_HEAP, "--smpp", "0");
            int accepted = 0;
            try (SmppApplication application = new SmppApplication(scenario.smppPort(), "load", "", "5550300")) {
                int status = 0;
                while (status == 0) {
                    status = application.submitPayload("5550101", LONG);
                    accepted += status == 0 ? PARTS : 0;
                }
                assertEquals(MESSAGE_QUEUE_FULL, status);
            }
            assertTrue(accepted > 5_000, accepted + " accepted");
            center.kill();
            RunningProgram again = scenario.centerIn(SMALL_HEAP);
            again.say("messages");
            again.expect("end", "of", "messages", "count", Integer.toString(accepted));
            assertEquals(0, again.quit());
        }
    }
}
