package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.ConsoleEvent;
import blackbox.RunningProgram;
import blackbox.Scenario;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import simgsm.dtmf.DtmfReceiver;

/** The gateway and its pages with Chromium, zbarimg and Python's websockets. */
@Tag("peer")
@Isolated("sound in real time")
class BrowserTest {
    @TempDir
    Path folder;

    @Test
    void chromiumDrivesTheRobotByKeyboardAndTouch() throws Exception {
        Peer.CHROMIUM.require();
        Peer.require(Peer.NODE.run("-e", "require('puppeteer-core')").status() == 0, "puppeteer-core (Node)");
        try (Scenario scenario = new Scenario("Chromium drives the robot")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--http", "0", "--speak");
            RunningProgram gateway = scenario.gateway(
                    "--robots", "http://127.0.0.1:" + robot.said("ready").field("http"));
            ConsoleEvent ready = gateway.expect("ready");
            Path sound = folder.resolve("played.raw");
            Path code = folder.resolve("code.png");
            ProcessBuilder browser = Peer.NODE.process(
                    Peer.source("browser_order.js"),
                    ready.field("link"),
                    Scenario.ROBOT,
                    sound.toString(),
                    code.toString());
            browser.environment().put("CHROMIUM", Peer.CHROMIUM.path().toString());
            String printed = Peer.run(browser).expectSuccess();

            assertTrue(printed.contains("secure false"), printed);
            assertTrue(printed.contains("signs #* 0\nleft Key 5 released: the page was left 0\n"), printed);
            assertTrue(printed.contains("frames after a minute 100\n"), printed);
            assertTrue(printed.contains("line In call with " + Scenario.ROBOT + "\n"), printed);
            assertTrue(
                    printed.contains("tones 1 connection accepted 6 executing 3 executed 6 executing 3 executed"),
                    printed);
            assertTrue(printed.contains("state Stopped x 0.20 m y 0.00 m heading 270\u00b0"), printed);
            assertTrue(printed.contains("said Done stopped at x twenty"), printed);
            assertTrue(printed.contains("redial " + Scenario.ROBOT), printed);
            assertTrue(printed.lines().anyMatch(line -> line.matches("calls .*To " + Scenario.ROBOT + " .*")), printed);
            assertTrue(printed.contains("up Setup, down Call Proceeding"), printed);
            assertTrue(printed.contains("faults 0"), printed);
            StringBuilder keys = new StringBuilder();
            new DtmfReceiver(digit -> keys.append(digit.key().symbol())).accept(samples(sound));
            assertEquals("16363", keys.toString(), "what the page played");
            gateway.expect("joined", "name", "Ana");
            Peer.ZBARIMG.require();
            String read = Peer.ZBARIMG.run("-q", "--raw", code.toString()).text();
            assertTrue(read.lines().anyMatch(ready.field("link")::equals), read);
        }
    }

    /** {@code -Dkeys=900} is the long run. */
    @Test
    void eachKeyThatIsTypedInChromiumIsReceivedByTheRobotsModemOnce() throws Exception {
        Peer.CHROMIUM.require();
        Peer.require(Peer.NODE.run("-e", "require('puppeteer-core')").status() == 0, "puppeteer-core (Node)");
        try (Scenario scenario = new Scenario("Keys typed in Chromium")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map");
            ProcessBuilder browser = Peer.NODE.process(
                    Peer.source("browser_keys.js"),
                    scenario.gateway().expect("ready").field("link"),
                    Scenario.ROBOT,
                    System.getProperty("keys", "60"));
            browser.environment().put("CHROMIUM", Peer.CHROMIUM.path().toString());
            List<String> typed = Peer.run(browser)
                    .expectSuccess()
                    .lines()
                    .filter(line -> line.startsWith("key "))
                    .map(line -> line.substring(4))
                    .toList();
            robot.say("robots");
            List<String> received = robot.expectAll("end").stream()
                    .filter(event -> event.name().equals("keys"))
                    .map(event -> event.field("keys"))
                    .toList();
            scenario.tell(typed.size() + " keys typed");
            assertEquals(String.join("", typed), String.join("", received));
        }
    }

    @Test
    void pythonsWebsocketsOrdersByKeysAndIsClosedByTheCodesOfTheContract() throws Exception {
        Peer.SOX.require();
        Peer.require(Peer.PYTHON.run("-c", "import websockets").status() == 0, "websockets (Python)");
        try (Scenario scenario = new Scenario("Python's websockets orders")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map");
            String web = scenario.gateway().expect("ready").field("web");
            Path wav = folder.resolve("keys.wav");
            Path sound = folder.resolve("keys.al");
            Audio.tool("tones", "**#**20**", wav.toString());
            Peer.SOX.run(wav.toString(), "-t", "al", sound.toString()).expectSuccess();
            String printed = Peer.PYTHON
                    .run(
                            Peer.source("websockets_order.py"),
                            "ws://127.0.0.1:" + web + "/phone",
                            "word",
                            Scenario.ROBOT,
                            sound.toString())
                    .expectSuccess();
            robot.expect("order", "text", "**#**20**", "verdict", "accepted");
            assertEquals(
                    List.of(
                            "tone executed",
                            "wrong key 4001",
                            "no JSON 1008",
                            "100 octets 1003",
                            "over the limit 1009",
                            "fragments of 100 octets 1003"),
                    printed.lines().toList());
        }
    }

    private static short[] samples(Path raw) throws Exception {
        short[] samples = new short[(int) Files.size(raw) / 2];
        ByteBuffer.wrap(Files.readAllBytes(raw))
                .order(ByteOrder.LITTLE_ENDIAN)
                .asShortBuffer()
                .get(samples);
        return samples;
    }
}
