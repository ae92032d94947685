package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.RunningProgram;
import blackbox.Scenario;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;

/** Wireshark names the speech of captures as RTP without any setting, finds none lost, and its samples hold the keys. */
@Tag("peer")
@ResourceLock("speech over UDP on the loopback interface")
class WiresharkPlaysSpeechTest {
    private static final String ORDER = "**#**20**";

    @TempDir
    Path folder;

    @BeforeAll
    static void requirePeers() {
        Peer.TSHARK.require();
        Peer.SOX.require();
        Peer.MULTIMON_NG.require();
    }

    /** An order by tones, captured. */
    private static Path capturedOrder(Scenario scenario, String... options) throws Exception {
        Path capture = scenario.folder().resolve("order.pcap");
        String[] all = Stream.concat(Stream.of("--capture", capture.toString()), Stream.of(options))
                .toArray(String[]::new);
        RunningProgram center = scenario.center(all);
        scenario.robot("empty.map");
        RunningProgram phone = scenario.phone(Scenario.PHONE);
        scenario.call(phone);
        phone.say("press " + ORDER).expect("tone", "key", "3");
        phone.say("hangup").expect("released");
        center.expect("call", "state", "released");
        assertEquals(0, center.quit());
        return capture;
    }

    private void requirePlayable(Path capture) throws Exception {
        assertEquals(Set.of("8"), Set.copyOf(Wireshark.fields(capture, "rtp", "rtp.p_type")));
        List<Wireshark.RtpStream> streams = Wireshark.rtpStreams(capture);
        assertEquals(4, streams.size(), "each leg in both directions: " + streams);
        Set<String> heard = new HashSet<>();
        for (Wireshark.RtpStream stream : streams) {
            assertEquals("g711A", stream.payload());
            assertEquals(0, stream.lost(), stream.toString());
            Path samples = Files.write(folder.resolve("stream.al"), stream.payloads(capture));
            assertEquals(160 * stream.packets(), Files.size(samples));
            heard.add(Audio.keysHeardByMultimonNg(folder, "-t", "al", "-r", "8000", "-c", "1", samples.toString()));
        }
        assertTrue(heard.contains(ORDER), heard.toString());
        assertTrue(heard.contains("163"), heard.toString());
        assertEquals(2, heard.size(), "both legs hold the same: " + heard);
        Wireshark.requireSound(capture, "Setup", "Connect Acknowledge");
        assertEquals(List.of(), Wireshark.fields(capture, "data", "frame.number"), "nothing is just data");
    }

    @Test
    void aCaptureHoldsTheKeysAsRtp() throws Exception {
        try (Scenario scenario = new Scenario("speech in a capture, played by Wireshark")) {
            requirePlayable(capturedOrder(scenario));
        }
    }

    @Test
    void speechOverUdpIsTheSameOnTheWire() throws Exception {
        try (Scenario scenario = new Scenario("speech over UDP, played by Wireshark")) {
            requirePlayable(capturedOrder(scenario, "--rtp", "udp"));
        }
    }
}
