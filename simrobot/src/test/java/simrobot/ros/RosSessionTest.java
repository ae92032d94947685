package simrobot.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.math.BigDecimal;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.web.AccessKeys;
import simgsm.web.JsonReader;
import simgsm.web.WebSocket;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationThread;
import simrobot.world.World;

/** A client's session as a conversation, with the time in the test's hand; the simulation's thread is not started. */
class RosSessionTest {
    private static final String ADVERTISE =
            "{\"op\":\"advertise\",\"topic\":\"/cmd_vel\",\"type\":\"geometry_msgs/Twist\"}";
    private static final String DRIVE = "{\"op\":\"publish\",\"id\":\"p\",\"topic\":\"/cmd_vel\",\"msg\":{}}";

    private final List<Map<String, Object>> heard = new ArrayList<>();
    private final List<String> orders = new ArrayList<>();
    private final SimulationThread simulation = new SimulationThread(new Simulation(World.bare(), 1));
    private List<String> robots = List.of("ann");
    private Optional<AccessKeys> keys = Optional.empty();
    private InetAddress peer = InetAddress.getLoopbackAddress();
    private boolean isLocalPage = true;
    private boolean isSlow;
    private RosServer server;
    private RosSession session;

    @BeforeEach
    void open() throws IOException {
        server = new RosServer(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), new Source());
        session = new RosSession(new Socket(), server);
    }

    @AfterEach
    void close() {
        server.close();
    }

    private final class Source implements RosSource {
        @Override
        public List<String> robots() {
            return robots;
        }

        @Override
        public SimulationThread simulation() {
            return simulation;
        }

        @Override
        public Optional<AccessKeys> keys() {
            return keys;
        }

        @Override
        public void order(String robot, String operator, String pressed, BiConsumer<Integer, String> ended) {
            orders.add(robot + " " + operator + " " + pressed);
        }
    }

    private final class Socket implements WebSocket {
        @Override
        public void send(String text) {
            heard.add(JsonReader.object(text));
        }

        @Override
        public void send(byte[] octets) {
            throw new AssertionError("everything is JSON");
        }

        @Override
        public void close(int code, String reason) {
            throw new AssertionError(reason);
        }

        @Override
        public boolean hasOutput() {
            return isSlow;
        }

        @Override
        public InetAddress peer() {
            return peer;
        }

        @Override
        public boolean isLocalPage() {
            return isLocalPage;
        }
    }

    /** The one answer to a message. */
    private Map<String, Object> answer(String message) {
        heard.clear();
        session.text(message);
        assertEquals(1, heard.size(), heard.toString());
        return heard.get(0);
    }

    private void accept(String message) {
        heard.clear();
        session.text(message);
        assertEquals(List.of(), heard);
    }

    private static String call(String service, String arguments) {
        return "{\"op\":\"call_service\",\"id\":1,\"service\":\"" + service + "\",\"args\":" + arguments + "}";
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "hello | JSON, position 1: expected a value |",
                "[1] | expected a JSON object |",
                "{} | expected op |",
                "{'op':7,'id':[1]} | op: expected a string | [1]",
                "{'op':'fly','id':'a'} | unknown op fly | a",
                "{'op':'fly','id':1e400} | unknown op fly | 1E+400",
                "{'op':'set_level','level':'error','id':3} | unknown op set_level | 3",
                "{'op':'subscribe','id':1.5} | expected topic | 1.5",
                "{'op':'subscribe','topic':'/nope','id':'a'} | topic /nope does not exist | a",
                "{'op':'subscribe','topic':'/ann/odom','type':'std_msgs/String'} | has the type nav_msgs/Odometry, not std |",
                "{'op':'subscribe','topic':'/cmd_vel'} | is published by clients |",
                "{'op':'subscribe','topic':'/tf','throttle_rate':-1} | throttle_rate: expected a number of milliseconds |",
                "{'op':'unsubscribe','topic':'/tf'} | topic /tf is not subscribed |",
                "{'op':'advertise','topic':'/ann/odom','type':'nav_msgs/Odometry'} | is published by the robot only |",
                "{'op':'advertise','topic':'/cmd_vel','type':'std_msgs/String'} | has the type geometry_msgs/Twist |",
                "{'op':'unadvertise','topic':'/cmd_vel'} | topic /cmd_vel is not advertised |",
                "{'op':'publish','topic':'/cmd_vel','msg':{}} | is not advertised, expected op advertise first |",
                "{'op':'publish','topic':'/tf','msg':{}} | is published by the robot only |",
                "{'op':'auth','key':'x'} | there are no keys |",
                "{'op':'call_service'} | expected service |",
            })
    void eachWrongMessageIsAnsweredByItsId(String message, String reason, String id) {
        Map<String, Object> answer = answer(message.replace('\'', '"'));
        assertEquals("status", answer.get("op"));
        assertEquals("error", answer.get("level"));
        assertTrue(answer.get("msg").toString().contains(reason), answer.toString());
        assertEquals(
                id, Optional.ofNullable(answer.get("id")).map(Object::toString).orElse(null));
        assertEquals(id != null, answer.containsKey("id"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "{'linear':{'x':1e400}} | linear.x: expected a finite number",
                "{'linear':{'y':null}} | linear.y: expected a finite number",
                "{'angular':{'z':'1'}} | angular.z: expected a finite number",
                "{'linear':{'speed':1}} | linear does not have a field speed",
                "{'linear':[0.1]} | linear: expected an object",
                "{'speed':1} | msg does not have a field speed",
                "{'header':{},'linear':{}} | msg does not have a field linear",
                "{'header':{}} | twist: expected an object",
                "[] | msg: expected an object",
            })
    void aVelocityWithAWrongFieldIsRefusedAsAWhole(String velocity, String reason) {
        accept(ADVERTISE);
        Map<String, Object> answer =
                answer("{\"op\":\"publish\",\"topic\":\"cmd_vel\",\"msg\":" + velocity.replace('\'', '"') + "}");
        assertEquals(reason, answer.get("msg"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "{} | 0 | 0",
                "{'linear':{'x':0.2},'angular':{'z':-0.5}} | 0.2 | -0.5",
                "{'header':{'frame_id':''},'twist':{'linear':{'x':-1,'y':2}}} | -1 | 0",
                "{'twist':{'angular':{'z':1e-3}}} | 0 | 0.001",
            })
    void aVelocityIsReadByTheFieldsThatItHas(String velocity, double ahead, double turn) {
        assertEquals(new Twist(ahead, turn), Twist.of(JsonReader.parse(velocity.replace('\'', '"'))));
    }

    @Test
    void binaryMessagesAreRefused() {
        session.binary(new byte[] {1});
        assertEquals("expected JSON in a text message", heard.get(0).get("msg"));
    }

    private List<String> due(long millis) {
        return session.due(millis * 1_000_000).stream()
                .map(wanted -> wanted.name() + " " + wanted.generation())
                .toList();
    }

    @Test
    void messagesAreDueAtTheTopicsRateOrSlower() {
        accept("{\"op\":\"subscribe\",\"topic\":\"/clock\"}");
        accept("{\"op\":\"subscribe\",\"topic\":\"tf\",\"type\":\"tf2_msgs/msg/TFMessage\",\"throttle_rate\":200}");
        assertEquals(
                List.of("/clock ROS_1", "/tf ROS_2"),
                due(1_000).stream().sorted().toList());
        assertEquals(List.of(), due(1_020));
        assertEquals(List.of("/clock ROS_1"), due(1_049));
        assertEquals(List.of("/clock ROS_1"), due(1_150));
        assertEquals(2, due(1_200).size());
    }

    @Test
    void aSlowClientGetsNothingUntilItHasTakenTheLast() {
        accept("{\"op\":\"subscribe\",\"topic\":\"/clock\"}");
        isSlow = true;
        assertEquals(List.of(), due(1_000));
        isSlow = false;
        assertEquals(List.of("/clock ROS_1"), due(9_000));
    }

    @Test
    void aClientThatSubscribesTwiceGetsEachMessageOnceUntilBothHaveEnded() {
        accept("{\"op\":\"subscribe\",\"id\":1,\"topic\":\"/clock\",\"throttle_rate\":1000}");
        accept("{\"op\":\"subscribe\",\"id\":2,\"topic\":\"/clock\"}");
        assertEquals(1, due(1_000).size());
        assertEquals(1, due(1_050).size());
        accept("{\"op\":\"unsubscribe\",\"id\":2,\"topic\":\"/clock\"}");
        assertEquals(0, due(1_500).size());
        assertEquals(1, due(2_050).size());
        assertEquals(
                "topic /clock is not subscribed by this id",
                answer("{\"op\":\"unsubscribe\",\"id\":2,\"topic\":\"/clock\"}").get("msg"));
        accept("{\"op\":\"unsubscribe\",\"topic\":\"/clock\"}");
        assertFalse(session.hasSubscriptions());
    }

    @Test
    void theGenerationIsThatOfTheNewestSubscriptionLeft() {
        accept("{\"op\":\"subscribe\",\"id\":1,\"topic\":\"/clock\"}");
        accept("{\"op\":\"subscribe\",\"id\":2,\"topic\":\"/clock\",\"type\":\"rosgraph_msgs/msg/Clock\"}");
        assertEquals(List.of("/clock ROS_2"), due(1_000));
        accept("{\"op\":\"unsubscribe\",\"id\":2,\"topic\":\"/clock\"}");
        assertEquals(List.of("/clock ROS_1"), due(2_000));
    }

    @Test
    void subscriptionsAreCountedOverAllTopics() {
        for (int i = 0; i < 100; i++) {
            accept("{\"op\":\"subscribe\",\"id\":" + i + ",\"topic\":\"" + (i % 2 == 0 ? "/tf" : "/clock") + "\"}");
        }
        assertEquals(
                "over 100 subscriptions",
                answer("{\"op\":\"subscribe\",\"topic\":\"/ann/odom\"}").get("msg"));
        assertEquals(2, due(1_000).size());
    }

    @Test
    void theServicesOfRosapiAnswerByNamesWithAndWithoutASlash() {
        Map<?, ?> values = (Map<?, ?>) answer(call("rosapi/topics", "{}")).get("values");
        assertEquals(
                List.of(
                        "/ann/odom",
                        "/ann/scan",
                        "/ann/sonar",
                        "/ann/battery_state",
                        "/ann/camera/compressed",
                        "/tf",
                        "/clock",
                        "/ann/cmd_vel",
                        "/cmd_vel"),
                values.get("topics"));
        assertEquals("nav_msgs/Odometry", ((List<?>) values.get("types")).get(0));
        assertEquals(
                Map.of("type", "sensor_msgs/LaserScan"),
                answer(call("/rosapi/topic_type", "[\"/ann/scan\"]")).get("values"));
        assertEquals(
                Map.of("type", ""),
                answer(call("/rosapi/topic_type", "{\"topic\":\"/x\"}")).get("values"));
        Map<String, Object> ofRos2 = answer("{\"op\":\"call_service\",\"service\":\"/rosapi/topic_type\","
                + "\"type\":\"rosapi_msgs/srv/TopicType\",\"args\":{\"topic\":\"/tf\"}}");
        assertEquals(Map.of("type", "tf2_msgs/msg/TFMessage"), ofRos2.get("values"));
        assertFalse(ofRos2.containsKey("id"));
    }

    @Test
    void severalRobotsHaveTopicsOfTheirOwnOnly() {
        robots = List.of("ann", "b$1\\n");
        Map<String, RosTopic.Source> topics = server.topics();
        assertEquals(14, topics.size());
        assertEquals("b$1\\n", topics.get("/b$1\\n/cmd_vel").robot());
        assertFalse(topics.containsKey("/cmd_vel"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "/nope | {} | Service /nope does not exist",
                "/ann/order | {'key':1} | args does not have a field key",
                "/ann/order | {} | expected keys",
                "/ann/order | {'keys':1} | keys: expected a string",
                "/ann/order | ['1','2'] | args: expected an object or at most 1 values",
                "/rosapi/topics | 'x' | args: expected an object or at most 0 values",
            })
    void aWrongCallIsAnsweredWithoutAResult(String service, String arguments, String reason) {
        Map<String, Object> answer = answer(call(service, arguments.replace('\'', '"')));
        assertEquals("service_response", answer.get("op"));
        assertEquals(false, answer.get("result"));
        assertEquals(reason, answer.get("values"));
        assertEquals(service, answer.get("service"));
        assertEquals(BigDecimal.ONE, answer.get("id"));
    }

    @ParameterizedTest
    @CsvSource({"192.0.2.1, true", "127.0.0.1, false"})
    void withoutKeysNoOtherMachineAndNoPageOfAnotherHostMovesTheRobotButEachReads(String from, boolean isLocal)
            throws IOException {
        peer = InetAddress.getByName(from);
        isLocalPage = isLocal;
        accept(ADVERTISE);
        assertTrue(answer(DRIVE).get("msg").toString().startsWith("without --http-keys only programs of"));
        assertEquals(false, answer(call("/ann/order", "[\"#*0\"]")).get("result"));
        assertEquals(List.of(), orders);
        accept("{\"op\":\"subscribe\",\"topic\":\"/clock\"}");
        assertEquals(1, due(1_000).size());
    }

    @Test
    void withKeysOnlyTheirOperatorsMoveTheRobot(@TempDir Path folder) throws IOException {
        keys = Optional.of(AccessKeys.read(Files.writeString(folder.resolve("keys"), "eva=secret\n")));
        accept(ADVERTISE);
        assertTrue(answer(DRIVE).get("msg").toString().startsWith("only with a key"));
        assertEquals("error", answer("{\"op\":\"auth\",\"key\":\"wrong\"}").get("level"));
        assertEquals("error", answer(DRIVE).get("level"));
        peer = InetAddress.getByName("192.0.2.1");
        isLocalPage = false;
        Map<String, Object> welcome = answer("{\"op\":\"auth\",\"id\":\"k\",\"key\":\"secret\"}");
        assertEquals("authenticated as eva", welcome.get("msg"));
        assertEquals("info", welcome.get("level"));
        accept(DRIVE);
        accept(call("ann/order", "{\"keys\":\"** #*0 **\"}"));
        assertEquals(List.of("ann eva ** #*0 **"), orders);
    }

    @Test
    void withoutKeysAProgramOfThisMachineMovesTheRobot() {
        accept(ADVERTISE);
        accept(DRIVE);
        accept(call("/ann/order", "[\"** #*0 **\"]"));
        assertEquals(List.of("ann ros ** #*0 **"), orders);
    }
}
