package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Calls whose speech goes as RTP over UDP beside the terminals' links. */
class SpeechOverUdpTest {
    private static final int SPEECH = 0xe1;
    private static final int MGCP = 0xfc;

    @Test
    void anOrderByTonesMovesTheRobotAndItsReplyIsHeard() throws Exception {
        try (Scenario scenario = new Scenario("an order, its speech over UDP")) {
            Path file = scenario.folder().resolve("udp.pcap");
            RunningProgram center = scenario.center("--rtp", "udp", "--capture", file.toString());
            scenario.robot("empty.map");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            for (int call = 1; call <= 2; call++) {
                scenario.call(phone);
                phone.say("press ** #**20 **").expect("tone", "key", "3");
                phone.say("hangup").expect("released");
                center.expect("call", "state", "released");
            }
            // Each terminal's link keeps its order: behind the order and its answer nothing of the calls is on its way.
            phone.say("sms 5550200 ** #*0 **").expect("sms", "from", "5550200");
            assertEquals(0, center.quit());
            CaptureFile capture = CaptureFile.read(file);
            assertEquals(0, capture.frames(SPEECH));
            assertTrue(capture.frames(MGCP) >= 16, "two legs of two calls, each created and deleted with answers");
            assertTrue(capture.datagrams().size() > 200, capture.datagrams().size() + " datagrams");
        }
    }

    @Test
    void anUnknownTransportIsAUsageError() throws Exception {
        FinishedProgram center = FinishedProgram.run("simgsm-center", "--headless", "--rtp", "sctp");

        assertEquals(2, center.status());
        assertTrue(center.error().contains("--rtp"), center.error());
    }
}
