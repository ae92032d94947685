package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.RunningProgram;
import blackbox.Scenario;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** Orders over HTTP by curl: a shell script is a program that drives a robot. */
@Tag("peer")
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class CurlOrdersTest {
    private Scenario scenario;
    private RunningProgram robot;
    private String orders;

    @BeforeAll
    void start() throws Exception {
        Peer.CURL.require();
        scenario = new Scenario("orders by curl");
        Path keys = Files.writeString(scenario.folder().resolve("keys"), "ana=k1\nben=k2\n");
        scenario.center();
        robot = scenario.robot("empty.map", "--http", "0", "--http-keys", keys.toString(), "--speed", "10");
        orders = "http://127.0.0.1:" + robot.said("ready").field("http") + "/robots/robot/orders";
    }

    @AfterAll
    void stop() throws Exception {
        if (scenario != null) {
            scenario.close();
        }
    }

    /** What curl prints: the body, a blank and what is asked of it. */
    private String curl(String asked, String... arguments) throws Exception {
        List<String> all = new ArrayList<>(List.of("-s", "-w", " " + asked));
        all.addAll(List.of(arguments));
        return Peer.CURL.run(all.toArray(String[]::new)).expectSuccess();
    }

    private String post(String key, String asked, String... arguments) throws Exception {
        List<String> all = new ArrayList<>(
                List.of("-H", "Authorization: Bearer " + key, "-H", "Content-Type: application/json", orders));
        all.addAll(List.of(arguments));
        return curl(asked, all.toArray(String[]::new));
    }

    @Test
    void theLocationOfAnOrderTellsItsOutcome() throws Exception {
        robot.say("place 2 2 90").expect("pose", "x", "2.0000");
        String placed = post("k1", "%{http_code} %header{location}", "-d", "{\"keys\":\"** #**20 **\"}");
        assertTrue(placed.matches("\\{.*} 202 /robots/robot/orders/1"), placed);
        robot.expect("outcome", "tone", "3");
        assertEquals(
                "{\"id\":1,\"keys\":\"** #**20 **\",\"from\":\"ana\",\"verdict\":\"accepted\",\"state\":\"ended\",\"tone\":3,"
                        + "\"text\":\"Done: #**20. Stopped at 2.000 2.200 m, heading 90.0.\","
                        + "\"pose\":{\"x\":2.0000,\"y\":2.2000,\"heading\":90.00}} 200",
                curl("%{http_code}", orders + "/1"));
    }

    @Test
    void aRefusalSaysWhyAndALargeBodyIsReadNoFurther() throws Exception {
        assertEquals("{\"error\":\"wrong key\"} 401", post("k3", "%{http_code}", "-d", "{}"));
        assertEquals(
                "{\"error\":\"expected Content-Type: application/json, found application/x-www-form-urlencoded\"} 415",
                curl("%{http_code}", "-H", "Authorization: Bearer k1", "-d", "keys=**", orders));
        Path large = Files.write(scenario.folder().resolve("large"), new byte[10_000_000]);
        for (String way : List.of("Expect:", "Expect: 100-continue", "Transfer-Encoding: chunked")) {
            assertEquals(
                    "{\"error\":\"expected at most 1024 octets, found more\"} 413",
                    post("k1", "%{http_code}", "-H", way, "--data-binary", "@" + large),
                    way);
        }
    }

    /** The requests share one connection, so that they are faster than the limit; curl waits as Retry-After says. */
    @Test
    void curlWaitsWhereItIsTooFastAndEachOrderIsTakenOnce() throws Exception {
        String[] arguments = new String[30 + 4];
        Arrays.fill(arguments, orders);
        arguments[0] = "--retry";
        arguments[1] = "10";
        arguments[2] = "-d";
        arguments[3] = "{\"keys\":\"** #*0 **\"}";
        String printed = post("k2", "%{http_code}\\n", arguments);
        assertEquals(31, printed.lines().filter(line -> line.endsWith(" 202")).count(), printed);
    }
}
