package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** What Wireshark says of a capture; where it is not to be had, the rest of the calling test is skipped. */
final class Wireshark {
    private Wireshark() {}

    /** Requires that it names these messages, finds nothing malformed and warns of nothing. */
    static void requireSound(Path file, String... expectedNames) throws IOException {
        assumeTrue(isThere(), "no tshark here");
        List<String> names = names(file);
        for (String expected : expectedNames) {
            assertTrue(
                    names.stream().anyMatch(name -> name.toLowerCase().contains(expected.toLowerCase())),
                    expected + " is not in\n" + String.join("\n", names));
        }
        List<String> complaints = tshark(file, "-Y", "_ws.malformed || _ws.expert.severity >= 0x600000");
        assertEquals(List.of(), complaints);
    }

    /** The names of all signalling messages. */
    private static List<String> names(Path file) throws IOException {
        return tshark(file, "-Y", "gsm_abis_rsl", "-T", "fields", "-e", "_ws.col.Info");
    }

    private static boolean isThere() {
        try {
            return new ProcessBuilder("tshark", "--version")
                            .redirectErrorStream(true)
                            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                            .start()
                            .waitFor()
                    == 0;
        } catch (IOException | InterruptedException e) {
            return false;
        }
    }

    private static List<String> tshark(Path file, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of("tshark", "-n", "-r", file.toString()));
        command.addAll(List.of(arguments));
        Process process = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
                .lines()
                .toList();
    }
}
