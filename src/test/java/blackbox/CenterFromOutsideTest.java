package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** The centre by HTTP, and its records: metrics, lists, one message, refusals. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
public class CenterFromOutsideTest {
    private static final String ABSENT = "5559999";

    private final HttpClient client = HttpClient.newHttpClient();
    private Scenario scenario;
    private String url;

    /** A call, a refused call, a message that is delivered and one that waits. */
    public static void traffic(RunningProgram phone) {
        phone.say("dial " + Scenario.ROBOT).expect("tone", "key", "1");
        phone.say("hangup").expect("released");
        phone.say("dial 999").expect("released", "cause", "1");
        phone.say("sms " + ABSENT + " hello").expect("sms-sent", "to", ABSENT);
        phone.say("sms " + Scenario.ROBOT + " ** #*0 **").expect("sms", "from", Scenario.ROBOT);
    }

    @BeforeAll
    void traffic() {
        scenario = new Scenario("the centre from outside");
        scenario.center("--http", "0");
        url = scenario.centerUrl();
        scenario.robot("empty.map");
        traffic(scenario.phone(Scenario.PHONE));
    }

    @AfterAll
    void end() throws Exception {
        scenario.close();
    }

    private HttpResponse<String> request(String method, String path) throws IOException, InterruptedException {
        HttpRequest request = HttpRequest.newBuilder(URI.create(url + path))
                .method(method, HttpRequest.BodyPublishers.noBody())
                .build();
        return client.send(request, HttpResponse.BodyHandlers.ofString());
    }

    private String get(String path) throws IOException, InterruptedException {
        HttpResponse<String> response = request("GET", path);
        assertEquals(200, response.statusCode(), response.body());
        return response.body();
    }

    @Test
    void metricsCountWhatHasHappened() throws Exception {
        String metrics = get("metrics");

        for (String line : List.of(
                "simgsm_subscribers_attached 2",
                "simgsm_calls_initiated_total 2",
                "simgsm_calls_answered_total 1",
                "simgsm_calls_released_total{cause=\"1\"} 1",
                "simgsm_calls{state=\"active\"} 0",
                "simgsm_messages_total{state=\"accepted\"} 3")) {
            assertTrue(metrics.lines().anyMatch(line::equals), line + " in\n" + metrics);
        }
    }

    @Test
    void listsAreJson() throws Exception {
        assertTrue(get("subscribers").contains("{\"number\":\"5550100\",\"state\":\"attached\""));
        assertEquals("[]", get("calls"));
        String queue = get("queue");
        assertTrue(queue.startsWith("[{\"id\":1,\"from\":\"5550100\",\"to\":\"" + ABSENT + "\""), queue);
        assertEquals(queue, "[" + get("messages/1") + "]");
    }

    @Test
    void whatIsNotThereAndWhatIsNotAllowedIsSaid() throws Exception {
        assertEquals(404, request("GET", "messages/99").statusCode());
        assertEquals(404, request("GET", "messages/x").statusCode());
        assertEquals(404, request("GET", "").statusCode());
        HttpResponse<String> refused = request("DELETE", "messages/1");
        assertEquals(405, refused.statusCode());
        assertEquals("GET, HEAD", refused.headers().firstValue("Allow").orElse(""));
        assertEquals("", request("HEAD", "calls").body());
    }

    @Test
    void callsAndMessagesAreRecorded() throws Exception {
        try (Scenario other = new Scenario("records of a day")) {
            Path folder = other.folder().resolve("cdr");
            RunningProgram center = other.center("--cdr", folder.toString());
            other.robot("empty.map");
            traffic(other.phone(Scenario.PHONE));
            assertEquals(0, center.quit());
            List<String> lines;
            try (Stream<Path> files = Files.list(folder)) {
                lines = files.flatMap(CenterFromOutsideTest::lines).toList();
            }
            assertEquals("type,id,from,to,via,began,answered,ended,seconds,result,cause", lines.get(0));
            assertTrue(
                    lines.get(1).matches("call,1,5550100,5550200,,\\S+Z,\\S+Z,\\S+Z,[0-9.]+,answered,16"),
                    lines.get(1));
            assertTrue(lines.get(2).matches("call,2,5550100,999,,\\S+Z,,\\S+Z,0.000,refused,1"), lines.get(2));
            assertTrue(
                    lines.get(3).matches("message,2,5550100,5550200,,\\S+Z,,\\S+Z,[0-9.]+,delivered,"), lines.get(3));
        }
    }

    private static Stream<String> lines(Path file) {
        try {
            return Files.readAllLines(file).stream();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void aFolderThatCannotBeWrittenEndsTheStart() throws Exception {
        Path file = Files.writeString(scenario.folder().resolve("file"), "");
        FinishedProgram center = FinishedProgram.run(
                "simgsm-center",
                "--headless",
                "--port",
                "0",
                "--data",
                scenario.folder().resolve("other").toString(),
                "--cdr",
                file.toString());

        assertEquals(74, center.status());
        assertTrue(center.error().contains(file.toString()), center.error());
    }
}
