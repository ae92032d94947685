package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** A port answers its first client as fast as later ones: what the answer needs has been loaded before {@code ready}. */
class FirstClientTest {
    private static final HexFormat HEX = HexFormat.of();
    private static final byte[] SYNC0 = HEX.parseHex("fafb03000000");
    private static final byte[] ENQUIRE_LINK = HEX.parseHex("00000010000000150000000000000001");

    @Test
    void theFirstAnswerOfSimRobotsPortsLoadsNoClassOfTheirs() throws Exception {
        try (Scenario scenario = new Scenario("SimRobot's first clients")) {
            Path classes = scenario.folder().resolve("classes.txt");
            RunningProgram robot = scenario.start(
                    "robot",
                    logging(classes),
                    "simrobot",
                    "--headless",
                    "--center",
                    "127.0.0.1:1",
                    "--at",
                    "0",
                    "--p2os",
                    "0",
                    "--http",
                    "0");
            ConsoleEvent ready = robot.expect("ready");
            assertLoadsNothing(classes, ready.field("p2os"), "simrobot.p2os", SYNC0, "fa fb");
            assertLoadsNothing(classes, ready.field("at"), "simgsm.modem.at", ascii("AT\r"), "41 54");
            assertLoadsNothing(
                    classes, ready.field("http"), "simrobot.http", ascii("GET /robots HTTP/1.0\r\n\r\n"), "48 54");
        }
    }

    @Test
    void theFirstAnswerOfTheCentersPortsLoadsNoClassOfTheirs() throws Exception {
        try (Scenario scenario = new Scenario("the centre's first clients")) {
            Path classes = scenario.folder().resolve("classes.txt");
            RunningProgram center = scenario.start(
                    "centre",
                    logging(classes),
                    "simgsm-center",
                    "--headless",
                    "--port",
                    "0",
                    "--data",
                    scenario.folder().resolve("data").toString(),
                    "--smpp",
                    "0",
                    "--http",
                    "0");
            ConsoleEvent ready = center.expect("ready");
            assertLoadsNothing(classes, ready.field("port"), "simgsm.abis", new byte[0], "00");
            assertLoadsNothing(classes, ready.field("smpp"), "simgsm.center.smpp", ENQUIRE_LINK, "00");
            assertLoadsNothing(
                    classes, ready.field("http"), "simgsm.center.web", ascii("GET /metrics HTTP/1.0\r\n\r\n"), "48 54");
        }
    }

    private static Map<String, String> logging(Path classes) {
        return Map.of("JDK_JAVA_OPTIONS", "-Xlog:class+load:file=" + classes + ":tags");
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    /**
     * @param owner package of the port; others may load classes meanwhile, as the modem that looks for its centre
     * @param answer the first octets of the answer
     */
    private static void assertLoadsNothing(Path classes, String port, String owner, byte[] request, String answer)
            throws IOException {
        int before = of(owner, classes).size();
        try (Socket client = new Socket("127.0.0.1", Integer.parseInt(port))) {
            client.setSoTimeout(20_000);
            client.getOutputStream().write(request);
            byte[] expected = HEX.withDelimiter(" ").parseHex(answer);
            assertEquals(
                    answer,
                    HEX.withDelimiter(" ").formatHex(client.getInputStream().readNBytes(expected.length)));
        }
        List<String> after = of(owner, classes);
        assertTrue(before > 0, "no class is in the log");
        assertEquals(List.of(), after.subList(before, after.size()), "loaded for the first client of port " + port);
    }

    private static List<String> of(String owner, Path classes) throws IOException {
        return Files.readAllLines(classes).stream()
                // a periodic task that meets its first connection may make a lambda, beside the answer
                .filter(line -> line.contains("] " + owner + ".") && !line.contains("$$Lambda"))
                .toList();
    }
}
