package simgsm.air;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Runs tshark without any configuration; where it is not installed, the calling test is skipped. */
public final class Tshark {
    private Tshark() {}

    /** One line a packet: these fields, parted by {@code |}. */
    public static List<String> fields(PcapFile capture, Path folder, String... fields)
            throws IOException, InterruptedException {
        Path file = folder.resolve("capture.pcap");
        Path output = folder.resolve("lines.txt");
        capture.write(file);
        List<String> command =
                new ArrayList<>(List.of("tshark", "-r", file.toString(), "-T", "fields", "-E", "separator=|"));
        for (String field : fields) {
            command.add("-e");
            command.add(field);
        }
        ProcessBuilder tshark = new ProcessBuilder(command);
        tshark.environment().put("HOME", folder.toString());
        tshark.environment().put("LC_ALL", "C.UTF-8");
        tshark.environment().remove("XDG_CONFIG_HOME");
        tshark.redirectOutput(output.toFile()).redirectError(ProcessBuilder.Redirect.DISCARD);
        assertEquals(0, start(tshark).waitFor(), "tshark's exit status");
        return Files.readAllLines(output, StandardCharsets.UTF_8);
    }

    private static Process start(ProcessBuilder tshark) {
        try {
            return tshark.start();
        } catch (IOException missing) {
            assumeTrue(false, "tshark is not installed");
            throw new AssertionError(missing);
        }
    }
}
