package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.web.JsonReader;

/** Programs order robots over HTTP. Each test has a key of its own: the rate is limited for each. */
class HttpOrdersTest {
    private static final int OPERATORS = 60;
    private static final int PER_SECOND = 10;
    private static final String FORWARD = "{\"keys\":\"** #**20 **\"}";
    private static final AtomicInteger OPERATOR = new AtomicInteger();

    private static Scenario scenario;
    private static RunningProgram robots;
    private static String port;

    private final HttpClient client =
            HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    private final String operator = "op" + OPERATOR.incrementAndGet();

    @BeforeAll
    static void start() throws Exception {
        scenario = new Scenario("orders over HTTP");
        String[] lines = new String[OPERATORS];
        Arrays.setAll(lines, i -> "op" + i + "=key-of-op" + i);
        robots = robots(scenario, String.join("\n", lines), "--speed=10");
        port = robots.expect("ready").field("http");
    }

    private static RunningProgram robots(Scenario scenario, String keys, String... more) throws Exception {
        Path file = Files.writeString(scenario.folder().resolve("keys"), keys);
        List<String> options = Stream.concat(
                        Stream.of(
                                "--headless",
                                "--lang=en",
                                "--no-sound",
                                "--world=" + Scenario.world("empty.map"),
                                "--robot=ann=5550200",
                                "--robot=ben=5550201",
                                "--center=127.0.0.1:1",
                                "--http=0",
                                "--http-keys=" + file),
                        Stream.of(more))
                .toList();
        return scenario.start("robots", "simrobot", options.toArray(String[]::new));
    }

    @AfterAll
    static void stop() throws Exception {
        scenario.close();
    }

    private HttpRequest.Builder request(String path) {
        return HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + path));
    }

    private HttpRequest.Builder post(String robot, String body) {
        return request("/robots/" + robot + "/orders")
                .header("Authorization", "Bearer key-of-" + operator)
                .header("Content-Type", "application/json")
                .POST(BodyPublishers.ofString(body));
    }

    private HttpResponse<String> send(HttpRequest.Builder request) throws Exception {
        return client.send(request.build(), BodyHandlers.ofString());
    }

    private static String error(HttpResponse<String> answer) {
        Map<String, Object> json = JsonReader.object(answer.body());
        assertEquals(List.of("error"), List.copyOf(json.keySet()), answer.body());
        return json.get("error").toString();
    }

    private static String location(HttpResponse<String> answer) {
        assertEquals(202, answer.statusCode(), answer.body());
        return answer.headers().firstValue("Location").orElseThrow();
    }

    /** An order once it has ended. */
    private Map<String, Object> ended(String path) throws Exception {
        long end = System.nanoTime() + RunningProgram.PATIENCE_SECONDS * 1_000_000_000L;
        while (true) {
            Map<String, Object> order =
                    JsonReader.object(send(request(path).GET()).body());
            if (order.get("state").equals("ended")) {
                return order;
            }
            assertTrue(System.nanoTime() < end, order.toString());
        }
    }

    @Test
    void anOrderMovesTheRobotAndItsResourceTellsTheCourse() throws Exception {
        robots.say("@ann place 2 2 0").expect("pose", "robot", "ann", "x", "2.0000");
        HttpResponse<String> placed = send(post("ann", FORWARD));
        String path = location(placed);
        assertTrue(path.matches("/robots/ann/orders/[0-9]+"), path);
        Map<String, Object> first = JsonReader.object(placed.body());
        assertEquals("accepted", first.get("verdict"));

        Map<String, Object> order = ended(path);
        assertEquals(path, "/robots/ann/orders/" + order.get("id"));
        assertEquals("** #**20 **", order.get("keys"));
        assertEquals(operator, order.get("from"));
        assertEquals("3", order.get("tone").toString());
        assertEquals("Done: #**20. Stopped at 2.200 2.000 m, heading 0.0.", order.get("text"));
        assertEquals("{x=2.2000, y=2.0000, heading=0.00}", order.get("pose").toString());
        robots.expect("submitted", "robot", "ann", "from", operator, "text", "** #**20 **");
        robots.expect("order", "robot", "ann", "text", "**#**20**", "verdict", "accepted");
        robots.expect("outcome", "robot", "ann", "tone", "3");
        robots.say("@ann place 4 4 0").expect("pose", "robot", "ann", "x", "4.0000");
        assertEquals(order, ended(path), "the pose at the end stays");
    }

    @Test
    void aBusyRobotRefusesAndAStopIsObeyed() throws Exception {
        robots.say("@ben place 2 8 0").expect("pose", "robot", "ben");
        HttpResponse<String> placed = send(post("ben", "{\"keys\":\"**#**9000**\"}"));
        String far = location(placed);
        Map<String, Object> first = JsonReader.object(placed.body());
        assertEquals("accepted", first.get("verdict"));
        assertEquals("moving", first.get("state"));
        assertNull(first.get("tone"));
        Map<String, Object> refused = ended(location(send(post("ben", FORWARD))));
        assertEquals("refused", refused.get("verdict"));
        assertEquals("Executing a command.", refused.get("text"));
        Map<String, Object> stop = ended(location(send(post("ben", "{\"keys\":\"** ### **\"}"))));
        assertEquals("3", stop.get("tone").toString());
        Map<String, Object> stopped = ended(far);
        assertTrue(stopped.get("text").toString().startsWith("Stopped by order after "), stopped.toString());
        robots.say("@ben motors off").expect("status", "robot", "ben", "value", "No motors");
        Map<String, Object> impossible = ended(location(send(post("ben", FORWARD))));
        assertEquals("Not possible: no motors.", impossible.get("text"));
        robots.say("@ben motors on").expect("status", "robot", "ben", "value", "Stopped");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"keys\":\"** #**0 **\"}|Not a valid command: number expected at key 7. Range 1..9999 cm.",
                "{\"keys\":\"\"}|Not a valid command: ** expected at key 1.",
                "{\"keys\":\"** #*9 **\"}|Not a valid command: no process 9 at key 5. Processes: 1 wander, 2 wall-follow.",
                "{\"keys\":20}|expected a field keys with the order as a string, such as \"** #**20 **\"",
                "{}|expected a field keys with the order as a string, such as \"** #**20 **\"",
                "[]|expected a JSON object",
                "keys|JSON, position 1: expected a value",
            })
    void contentThatIsNoOrderIs422WithPositionAndWhatWasExpected(String body, String text) throws Exception {
        HttpResponse<String> answer = send(post("ann", body));
        assertEquals(422, answer.statusCode());
        assertEquals(text, error(answer));
        assertFalse(answer.headers().firstValue("Location").isPresent());
    }

    @Test
    void otherRequestsAreRefusedEachWithItsStatusAndAText() throws Exception {
        HttpResponse<String> noKey = send(request("/robots/ann/orders").POST(BodyPublishers.ofString(FORWARD)));
        assertEquals(401, noKey.statusCode());
        assertEquals("Bearer", noKey.headers().firstValue("WWW-Authenticate").orElseThrow());
        assertEquals("expected a key as Authorization: Bearer KEY", error(noKey));
        HttpResponse<String> wrong = send(post("ann", FORWARD).setHeader("Authorization", "Bearer key-of-op"));
        assertEquals(401, wrong.statusCode());
        assertEquals("wrong key", error(wrong));
        for (String origin : List.of("http://elsewhere.example", "http://127.0.0.1:1", "null")) {
            HttpResponse<String> foreign = send(post("ann", FORWARD).header("Origin", origin));
            assertEquals(403, foreign.statusCode(), origin);
            assertEquals("the request comes from a page of another host", error(foreign));
        }
        location(send(post("ann", "{\"keys\":\"** ### **\"}").header("Origin", "http://127.0.0.1:" + port)));
        HttpResponse<String> nobody = send(post("nobody", FORWARD));
        assertEquals(404, nobody.statusCode());
        assertEquals("no robot nobody, expected one of ann, ben", error(nobody));
        assertEquals(404, send(request("/robots/ann/orders/0").GET()).statusCode());
        HttpResponse<String> large = send(post("ann", " ".repeat(1_023) + "{}"));
        assertEquals(413, large.statusCode());
        assertEquals("expected at most 1024 octets, found more", error(large));
        HttpResponse<String> form = send(post("ann", FORWARD).setHeader("Content-Type", "text/plain"));
        assertEquals(415, form.statusCode());
        assertEquals("expected Content-Type: application/json, found text/plain", error(form));
        assertEquals(
                415, send(post("ann", FORWARD).setHeader("Content-Type", ";")).statusCode());
        HttpResponse<String> read = send(request("/robots/ann/orders").GET());
        assertEquals(405, read.statusCode());
        assertEquals("POST", read.headers().firstValue("Allow").orElseThrow());
    }

    @Test
    void anIdempotencyKeyHasTheSameAnswerAgainAndPlacesOneOrder() throws Exception {
        HttpRequest once = post("ann", "{\"keys\":\"** #*0 **\"}")
                .header("Idempotency-Key", "one")
                .build();
        List<CompletableFuture<HttpResponse<String>>> atOnce = Stream.generate(
                        () -> client.sendAsync(once, BodyHandlers.ofString()))
                .limit(4)
                .toList();
        for (CompletableFuture<HttpResponse<String>> each : atOnce) {
            assertEquals(location(atOnce.get(0).join()), location(each.join()));
            assertEquals(atOnce.get(0).join().body(), each.join().body());
        }
        HttpResponse<String> other =
                send(post("ann", "{\"keys\":\"** ### **\"}").header("Idempotency-Key", "one"));
        assertEquals(422, other.statusCode());
        assertEquals("the Idempotency-Key came with another order within 24 h, expected a new one", error(other));
        String next = location(send(post("ann", "{\"keys\":\"** #*0 **\"}").header("Idempotency-Key", "two")));
        assertNotEquals(location(atOnce.get(0).join()), next);
        assertEquals(
                422,
                send(post("ann", FORWARD).header("Idempotency-Key", "a".repeat(256)))
                        .statusCode());
        robots.expect("submitted", "from", operator);
        robots.expect("submitted", "from", operator);
        robots.say("@ann place 4 4 0");
        robots.expectBefore(Set.of("submitted"), "pose", "robot", "ann", "x", "4.0000");
    }

    @Test
    void moreThanTenRequestsASecondOfOneKeyAreRefused() {
        HttpRequest report = post("ann", "{\"keys\":\"** #*0 **\"}").build();
        List<HttpResponse<String>> refused = List.of();
        for (int i = 0; i < 50 && refused.isEmpty(); i++) {
            refused =
                    Stream.generate(() -> client.sendAsync(report, BodyHandlers.ofString()))
                            .limit(2 * PER_SECOND)
                            .toList()
                            .stream()
                            .map(CompletableFuture::join)
                            .filter(answer -> answer.statusCode() != 202)
                            .toList();
        }
        assertFalse(refused.isEmpty());
        for (HttpResponse<String> each : refused) {
            assertEquals(429, each.statusCode());
            assertEquals("1", each.headers().firstValue("Retry-After").orElseThrow());
            assertEquals("more than 10 requests a second with this key", error(each));
        }
    }

    @Test
    void guessesAreSlowedForTheirAddressAlsoIfOneIsRight() throws Exception {
        try (Scenario guessed = new Scenario("guesses of keys over HTTP")) {
            String at = robots(guessed, operator + "=key-of-" + operator)
                    .expect("ready")
                    .field("http");
            HttpRequest.Builder post = HttpRequest.newBuilder(
                            URI.create("http://127.0.0.1:" + at + "/robots/ann/orders"))
                    .POST(BodyPublishers.ofString(FORWARD));
            List<Integer> statuses = Stream.generate(() ->
                            post.copy().header("Authorization", "Bearer guess").build())
                    .limit(50)
                    .map(guess -> client.sendAsync(guess, BodyHandlers.ofString()))
                    .toList()
                    .stream()
                    .map(answer -> answer.join().statusCode())
                    .toList();
            assertTrue(statuses.contains(401) && statuses.contains(429), statuses.toString());
            HttpResponse<String> right = null;
            for (int i = 0; i < 50 && (right == null || right.statusCode() != 429); i++) {
                send(post.copy().header("Authorization", "Bearer guess"));
                right = send(post.copy().header("Authorization", "Bearer key-of-" + operator));
            }
            assertEquals(429, right.statusCode());
            assertEquals(
                    "too many wrong keys from this address, expected at most one a second; try again in a second",
                    error(right));
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "ann=k1\\nben|74|, line 2: expected name=key",
                "ann=k1\\nann=k2|74|, line 2: expected each name once, found that of line 1",
            })
    void aFaultOfTheKeysFileEndsTheProgramAndNamesTheLine(String keys, int status, String text) throws Exception {
        try (Scenario wrong = new Scenario("a faulty file of keys")) {
            RunningProgram refused = robots(wrong, keys.replace("\\n", "\n"));
            assertEquals(status, refused.awaitExit());
            assertTrue(refused.log().contains(text), refused.log());
            assertFalse(refused.log().contains("k1"), refused.log());
        }
    }

    @Test
    void keysWithoutAPortAreAUsageErrorAndAPortWithoutKeysIsReadOnly() throws Exception {
        try (Scenario other = new Scenario("a port without keys")) {
            RunningProgram refused = other.start("refused", "simrobot", "--headless", "--http-keys=keys");
            assertEquals(2, refused.awaitExit());
            assertTrue(refused.log().contains("--http-keys: expected with --http PORT or --ros PORT"), refused.log());
            String readOnly = other.start("robot", "simrobot", "--headless", "--center=127.0.0.1:1", "--http=0")
                    .expect("ready")
                    .field("http");
            HttpResponse<String> answer =
                    send(HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + readOnly + "/robots/robot/orders"))
                            .POST(BodyPublishers.ofString(FORWARD)));
            assertEquals(405, answer.statusCode());
            assertEquals("GET, HEAD", answer.headers().firstValue("Allow").orElseThrow());
        }
    }
}
