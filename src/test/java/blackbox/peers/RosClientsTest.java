package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.Dist;
import blackbox.RunningProgram;
import blackbox.Scenario;
import com.sun.net.httpserver.HttpServer;
import java.io.BufferedReader;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** roslib 1.4.1, roslib 2.1 and roslibpy 2.1 read and drive a robot; killed, they leave it standing. */
@Tag("peer")
class RosClientsTest {
    @ParameterizedTest
    @CsvSource({"1, roslib-1", "2, roslib"})
    void roslibReadsDrivesAndOrders(String major, String library) throws Exception {
        Peer.NODE.require();
        Peer.require(Files.isDirectory(Peer.LIBRARIES.resolve("node_modules").resolve(library)), library + " (Node)");
        readsDrivesAndOrders(
                List.of(
                        "topics 9 sensor_msgs/LaserScan",
                        "type geometry_msgs/Twist",
                        "scan 181 false",
                        "camera jpeg true",
                        "odom odom true true",
                        "order 3 Done: #**20. Stopped",
                        "wrong Service /nope does not exist"),
                port -> Peer.NODE.process(Peer.source("roslib_drive.js"), port, major));
    }

    @Test
    void roslibpyReadsDrivesAndOrders() throws Exception {
        Peer.PYTHON.require();
        Peer.require(Files.isDirectory(Peer.LIBRARIES.resolve("python").resolve("roslibpy")), "roslibpy");
        readsDrivesAndOrders(
                List.of(
                        "topics 9 sensor_msgs/LaserScan",
                        "time True",
                        "scan 181 False",
                        "camera jpeg True True",
                        "odom True",
                        "order 3 Done: #**20. Stopped",
                        "wrong Service /nope does not exist"),
                port -> Peer.PYTHON.process(Peer.source("roslibpy_drive.py"), port));
    }

    @Test
    void thePageOfThePortsPageDrivesInChromiumAndTheRobotStandsWhenItIsClosed() throws Exception {
        Peer.CHROMIUM.require();
        Peer.require(Peer.NODE.run("-e", "require('puppeteer-core')").status() == 0, "puppeteer-core (Node)");
        Peer.require(Files.isDirectory(Peer.LIBRARIES.resolve("node_modules").resolve("roslib-1")), "roslib-1 (Node)");
        String html = Files.readString(Dist.root().resolve("docs/PORTS.md"))
                .lines()
                .filter(line -> line.startsWith("    "))
                .dropWhile(line -> !line.contains("roslib.min.js"))
                .limit(8)
                .collect(Collectors.joining("\n"));
        HttpServer pages = HttpServer.create(new InetSocketAddress("127.0.0.1", 0), 0);
        try (Scenario scenario = new Scenario("a page with roslib")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--ros", "0");
            byte[] body = html.replace("9090", robot.said("ready").field("ros")).getBytes(StandardCharsets.UTF_8);
            pages.createContext("/", exchange -> {
                exchange.getResponseHeaders().set("Content-Type", "text/html");
                exchange.sendResponseHeaders(200, body.length);
                exchange.getResponseBody().write(body);
                exchange.close();
            });
            pages.start();
            ProcessBuilder browser = Peer.NODE.process(
                    Peer.source("ros_page.js"),
                    "http://localhost:" + pages.getAddress().getPort() + "/");
            browser.environment().put("CHROMIUM", Peer.CHROMIUM.path().toString());
            String printed = Peer.run(browser).expectSuccess();
            assertTrue(printed.startsWith("place 0.0"), printed);
            robot.expect("status", "value", "Moving");
            robot.expect("status", "value", "Stopped");
        } finally {
            pages.stop(0);
        }
    }

    /** @param client of a port */
    private static void readsDrivesAndOrders(List<String> expected, Function<String, ProcessBuilder> client)
            throws Exception {
        try (Scenario scenario = new Scenario("a ROS client")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--ros", "0");
            Process process = client.apply(robot.said("ready").field("ros")).start();
            try (BufferedReader printed = process.inputReader()) {
                List<String> lines = new ArrayList<>();
                for (String line = printed.readLine();
                        line != null && !line.equals("driving");
                        line = printed.readLine()) {
                    lines.add(line.replaceFirst("(Stopped) at.*", "$1"));
                }
                lines.removeIf(line -> line.startsWith("ROSLib uses"));
                assertEquals(expected, lines);
                robot.expect("outcome", "tone", "3");
                robot.expect("status", "value", "Moving");
            } finally {
                process.destroyForcibly();
            }
            robot.expect("status", "value", "Stopped");
        }
    }
}
