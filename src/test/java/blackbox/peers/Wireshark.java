package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Reads captures with Wireshark's {@code tshark}. */
final class Wireshark {
    private Wireshark() {}

    /** Requires that tshark names these messages, finds nothing malformed and warns of nothing. */
    static void requireSound(Path file, String... expectedNames) throws IOException {
        List<String> names = tshark(file, "-Y", "gsm_abis_rsl", "-T", "fields", "-e", "_ws.col.Info");
        for (String expected : expectedNames) {
            assertTrue(
                    names.stream().anyMatch(name -> name.toLowerCase().contains(expected.toLowerCase())),
                    expected + " is not in\n" + String.join("\n", names));
        }
        assertEquals(List.of(), tshark(file, "-Y", "_ws.malformed || _ws.expert.severity >= 0x600000"));
    }

    /** The values of one field in all frames that pass the filter. */
    static List<String> fields(Path file, String filter, String field) throws IOException {
        return tshark(file, "-Y", filter, "-T", "fields", "-e", field);
    }

    private static List<String> tshark(Path file, String... arguments) throws IOException {
        List<String> all = new ArrayList<>(List.of("-n", "-r", file.toString()));
        all.addAll(List.of(arguments));
        Process process = Peer.TSHARK
                .process(all.toArray(String[]::new))
                .redirectErrorStream(false)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
                .lines()
                .toList();
    }
}
