package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import blackbox.RunningProgram;
import blackbox.Scenario;
import java.io.BufferedReader;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
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
