package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

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

    /** The lines of the frames that pass a filter where tshark reads a port by another protocol, as "tcp.port==3013,gsm_ipa". */
    static List<String> decoded(Path file, String decoding, String filter) throws IOException {
        return tshark(file, "-d", decoding, "-Y", filter);
    }

    /** The values of one field in all frames that pass the filter. */
    static List<String> fields(Path file, String filter, String field) throws IOException {
        return tshark(file, "-Y", filter, "-T", "fields", "-e", field);
    }

    /** All that tshark says of the frames that pass the filter. */
    static String words(Path file, String filter) throws IOException {
        return String.join("\n", tshark(file, "-V", "-Y", filter));
    }

    /**
     * A stream that tshark's analysis of RTP has found.
     *
     * @param lost packets lost, as the analysis prints them
     */
    record RtpStream(int fromPort, int toPort, String payload, int packets, int lost) {
        private static final Pattern LINE = Pattern.compile(
                "\\s*[0-9.]+\\s+[0-9.]+\\s+\\S+\\s+([0-9]+)\\s+\\S+\\s+([0-9]+)\\s+0x[0-9A-F]+\\s+(.+?)\\s+([0-9]+)\\s+(-?[0-9]+) \\(.*");

        private static Optional<RtpStream> of(String line) {
            Matcher fields = LINE.matcher(line);
            return fields.matches()
                    ? Optional.of(new RtpStream(
                            Integer.parseInt(fields.group(1)),
                            Integer.parseInt(fields.group(2)),
                            fields.group(3),
                            Integer.parseInt(fields.group(4)),
                            Integer.parseInt(fields.group(5))))
                    : Optional.empty();
        }

        /** The payloads of all packets, one after the other. */
        byte[] payloads(Path file) throws IOException {
            String hex = String.join("", fields(file, "rtp && udp.srcport == " + fromPort, "rtp.payload"));
            return HexFormat.of().parseHex(hex.replace(":", ""));
        }
    }

    /** The analysis of all RTP in a capture. */
    static List<RtpStream> rtpStreams(Path file) throws IOException {
        return tshark(file, "-q", "-z", "rtp,streams").stream()
                .flatMap(line -> RtpStream.of(line).stream())
                .toList();
    }

    private static List<String> tshark(Path file, String... arguments) throws IOException {
        List<String> all = new ArrayList<>(List.of("-n", "-r", file.toString()));
        all.addAll(List.of(arguments));
        Path complaints = Files.createTempFile("tshark", ".err");
        try {
            Process process = Peer.TSHARK
                    .process(all.toArray(String[]::new))
                    .redirectErrorStream(false)
                    .redirectError(complaints.toFile())
                    .start();
            String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertEquals(0, process.waitFor(), () -> all + " printed " + printed + text(complaints));
            return printed.lines().toList();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException(e);
        } finally {
            Files.delete(complaints);
        }
    }

    private static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            return e.getMessage();
        }
    }
}
