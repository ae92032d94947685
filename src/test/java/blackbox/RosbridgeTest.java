package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;

/** ROS programs read and drive a robot by the rosbridge protocol (spec/remote.md, 3; protocol version 2). */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class RosbridgeTest {
    private static final String ADVERTISE =
            "{'op':'advertise','topic':'/cmd_vel','type':'geometry_msgs/Twist','latch':false,'queue_size':100}";
    private static final String DRIVE =
            "{'op':'publish','id':'p','topic':'/cmd_vel','msg':{'linear':{'x':0.2,'y':0,'z':0},'angular':{'z':0}}}";

    private Scenario scenario;
    private RunningProgram robot;
    private String port;

    @BeforeAll
    void start() {
        scenario = new Scenario("ROS programs");
        scenario.center();
        robot = scenario.robot("empty.map", "--ros", "0");
        port = robot.said("ready").field("ros");
    }

    @AfterAll
    void end() throws IOException {
        scenario.close();
    }

    /** A client, whose messages are written with ' in place of ". */
    private static final class Client extends JsonSocket {
        Client(String port) {
            super(port, "/", builder -> builder);
        }

        Client(String port, String origin) {
            super(port, "/", builder -> builder.header("Origin", origin));
        }

        Client tell(String message) {
            say(message.replace('\'', '"'));
            return this;
        }

        Map<?, ?> message(String topic) {
            return (Map<?, ?>) expect(message -> topic.equals(message.get("topic")), "message of " + topic)
                    .get("msg");
        }

        String error() {
            return expect(message -> "error".equals(message.get("level")), "status message")
                    .get("msg")
                    .toString();
        }

        Map<String, Object> response(String id) {
            return expect(
                    message -> "service_response".equals(message.get("op")) && id.equals(message.get("id")),
                    "response " + id);
        }
    }

    private static double number(Object message, String path) {
        Object value = message;
        for (String step : path.split("\\.")) {
            value = ((Map<?, ?>) value).get(step);
        }
        return ((BigDecimal) value).doubleValue();
    }

    @Test
    void aProgramReadsAndDrivesUntilItIsSilent() {
        try (Client client = new Client(port)) {
            client.tell("{'op':'subscribe','topic':'/robot/odom','type':'nav_msgs/msg/Odometry'}");
            double before = number(client.message("/robot/odom"), "pose.pose.position.x");
            client.tell(ADVERTISE).tell(DRIVE);
            Map<?, ?> odometry;
            do {
                odometry = client.message("/robot/odom");
            } while (number(odometry, "twist.twist.linear.x") == 0);
            robot.expect("status", "value", "Moving");
            robot.expect("status", "value", "Stopped");
            do {
                odometry = client.message("/robot/odom");
            } while (number(odometry, "twist.twist.linear.x") != 0);
            assertTrue(number(odometry, "pose.pose.position.x") > before, odometry.toString());
            assertTrue(number(odometry, "header.stamp.sec") >= 0);
        }
    }

    @Test
    void aLostSocketBrakesAndAnOrderInProgressWins() {
        Client first = new Client(port);
        first.tell(ADVERTISE).tell(DRIVE);
        robot.expect("status", "value", "Moving");
        first.cut();
        robot.expect("status", "value", "Stopped");
        try (Client client = new Client(port)) {
            client.tell(ADVERTISE)
                    .tell("{'op':'call_service','id':'o','service':'/robot/order','args':{'keys':'** #**30 **'}}");
            robot.expect("submitted", "from", "ros", "text", "** #**30 **");
            robot.expect("status", "value", "Moving");
            ConsoleEvent before = robot.ask("pose", "pose");
            client.tell(DRIVE.replace("0.2", "-0.5"));
            assertEquals("robot robot executes an order, its velocity cannot be set", client.error());
            Map<String, Object> answer = client.response("o");
            assertEquals(true, answer.get("result"));
            assertEquals(3, number(answer, "values.tone"));
            assertTrue(answer.get("values").toString().contains("Done"), answer.toString());
            assertTrue(robot.ask("pose", "pose").number("x") > before.number("x"));
        }
    }

    @Test
    void anOrderFindsARobotThatAProgramDrivesMovingAsOneDrivenByP2os() {
        try (Client client = new Client(port)) {
            client.tell(ADVERTISE).tell(DRIVE);
            robot.expect("status", "value", "Moving");
            client.tell("{'op':'call_service','id':'o','service':'robot/order','args':['** #**30 **']}");
            assertEquals(6, number(client.response("o"), "values.tone"));
            robot.expect("status", "value", "Stopped");
        }
    }

    @Test
    void scanCameraClockAndTransformsCome() {
        try (Client client = new Client(port)) {
            client.tell("{'op':'subscribe','topic':'/robot/scan','compression':'png'}")
                    .tell("{'op':'subscribe','topic':'/robot/camera/compressed','fragment_size':200}")
                    .tell("{'op':'subscribe','topic':'/tf'}")
                    .tell("{'op':'subscribe','topic':'/clock'}");
            assertEquals(181, ((List<?>) client.message("/robot/scan").get("ranges")).size());
            assertTrue(client.message("/robot/camera/compressed")
                    .get("data")
                    .toString()
                    .startsWith("/9j/"));
            assertEquals(2, ((List<?>) client.message("/tf").get("transforms")).size());
            assertTrue(number(client.message("/clock"), "clock.secs") >= 0);
        }
    }

    @Test
    void theTopicsAreThoseOfThePortsPage() throws IOException {
        String page = Files.readString(Dist.root().resolve("docs/PORTS.md"));
        try (Client client = new Client(port)) {
            client.tell("{'op':'call_service','id':'t','service':'rosapi/topics','args':{}}");
            Map<?, ?> values = (Map<?, ?>) client.response("t").get("values");
            List<?> topics = (List<?>) values.get("topics");
            for (int i = 0; i < topics.size(); i++) {
                String name = topics.get(i)
                        .toString()
                        .replace("/robot/", "/NAME/")
                        .replaceFirst("^/cmd_vel", "/NAME/cmd_vel");
                String type = ((List<?>) values.get("types")).get(i).toString();
                assertTrue(
                        page.lines().anyMatch(line -> line.startsWith("| `" + name + "`") && line.contains(type)),
                        name + " " + type);
            }
        }
    }

    @Test
    void aPageOfAnotherHostReadsOnlyAndOtherPathsAreRefused() throws IOException {
        try (Client page = new Client(port, "http://elsewhere.example");
                Client file = new Client(port, "null");
                Client own = new Client(port, "http://localhost:8000")) {
            for (Client stranger : List.of(page, file)) {
                stranger.tell(ADVERTISE).tell(DRIVE);
                assertTrue(stranger.error().startsWith("without --http-keys only programs of"));
                stranger.tell("{'op':'subscribe','topic':'/clock'}").message("/clock");
            }
            assertTrue(robot.log().contains("a ROS client at 127.0.0.1: without --http-keys only"));
            own.tell(ADVERTISE).tell(DRIVE);
            robot.expect("status", "value", "Moving");
            robot.expect("status", "value", "Stopped");
        }
        CompletionException refused =
                assertThrows(CompletionException.class, () -> new JsonSocket(port, "/other", builder -> builder));
        assertTrue(Objects.toString(refused.getCause()).contains("Handshake"), refused.toString());
    }

    @Test
    void withKeysOnlyTheirOperatorsDrive(@TempDir Path folder) throws Exception {
        Path keys = Files.writeString(folder.resolve("keys"), "eva=secret\n");
        try (Scenario scenario = new Scenario("ROS programs with keys")) {
            RunningProgram locked = scenario.start(
                    "robot",
                    "simrobot",
                    "--headless",
                    "--center",
                    "127.0.0.1:1",
                    "--ros",
                    "0",
                    "--http-keys",
                    keys.toString());
            try (Client client = new Client(locked.expect("ready").field("ros"), "http://elsewhere.example")) {
                client.tell(ADVERTISE).tell(DRIVE);
                assertTrue(client.error().startsWith("only with a key"));
                client.tell("{'op':'auth','key':'other'}");
                assertEquals("wrong key", client.error());
                client.tell("{'op':'auth','id':1,'key':'secret'}");
                client.expect(message -> "info".equals(message.get("level")), "welcome");
                client.tell(DRIVE);
                locked.expect("status", "value", "Moving");
                locked.expect("status", "value", "Stopped");
                client.tell("{'op':'call_service','id':'o','service':'/robot/order','args':['** #*0 **']}");
                locked.expect("submitted", "from", "eva");
                assertEquals(3, number(client.response("o"), "values.tone"));
            }
        }
    }

    @Test
    void theClientBeyondTheLimitIsToldAndTheOthersGoOn() throws Exception {
        try (Scenario many = new Scenario("65 ROS programs")) {
            RunningProgram other =
                    many.start("robot", "simrobot", "--headless", "--center", "127.0.0.1:1", "--ros", "0");
            String open = other.expect("ready").field("ros");
            Client[] clients = new Client[64];
            for (int i = 0; i < clients.length; i++) {
                clients[i] = new Client(open);
                clients[i].tell("{'op':'subscribe','topic':'/clock'}").message("/clock");
            }
            try (Client last = new Client(open)) {
                assertEquals(1013, last.closeCode());
            }
            clients[0].message("/clock");
            clients[0].cut();
            try (Client next = new Client(open)) {
                next.tell("{'op':'subscribe','topic':'/clock'}").message("/clock");
            }
            for (Client client : clients) {
                client.close();
            }
        }
    }
}
