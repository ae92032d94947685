package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.dtmf.DtmfReceiver;

/** Browsers as subscribers (spec/remote.md, 1 and 2): a page's socket drives a robot, as an attached phone does. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class GatewayTest {
    private static final String JOIN = "{\"key\":\"word\",\"token\":\"\"}";

    private Scenario scenario;
    private RunningProgram robot;
    private RunningProgram gateway;
    private String port;

    @BeforeAll
    void start() {
        scenario = new Scenario("browsers");
        scenario.center();
        robot = scenario.robot("empty.map", "--http", "0", "--speak");
        String robots = "http://127.0.0.1:" + robot.said("ready").field("http");
        gateway = scenario.gateway("--robots", robots);
        ConsoleEvent ready = gateway.expect("ready");
        port = ready.field("web");
        assertEquals("http://127.0.0.1:" + port + "/#word", ready.field("link"));
    }

    @AfterAll
    void end() throws Exception {
        scenario.close();
    }

    private WebPhone join() {
        WebPhone phone = new WebPhone(port, JOIN);
        phone.expect("welcome");
        phone.expect("registered");
        return phone;
    }

    @Test
    void aPagesKeysAreSoundThatDrivesTheRobotAndItsToneComesBack() {
        try (WebPhone phone = join()) {
            phone.say("{\"do\":\"dial\",\"number\":\"5550200\"}");
            phone.expect("alerting");
            phone.expect("connected");
            phone.speak();
            assertEquals("connection accepted", phone.expect("tone", "key", "1").get("meaning"));
            phone.press("**#**20**");
            robot.expect("order", "text", "**#**20**", "verdict", "accepted");
            phone.expect("tone", "key", "6");
            assertEquals("executed", phone.expect("tone", "key", "3").get("meaning"));
            phone.expect("words", "text", robot.expect("said").field("text"));
            List<Character> keys = new ArrayList<>();
            new DtmfReceiver(digit -> keys.add(digit.key().symbol())).accept(phone.heard());
            assertEquals(List.of('1', '6', '3'), keys, "what the page plays");
            phone.say("{\"do\":\"hangup\"}");
            assertEquals("16", phone.expect("released").get("cause"));
        }
    }

    @Test
    void messagesGoBothWays() {
        try (WebPhone phone = join()) {
            phone.say("{\"do\":\"sms\",\"number\":\"5550200\",\"text\":\"** #*0 **\"}");
            phone.expect("sms-sent");
            assertEquals("5550200", phone.expect("sms").get("from"));
            phone.say("{\"do\":\"inbox\"}");
            assertEquals("5550200", phone.expect("message").get("from"));
            assertEquals("1", phone.expect("end", "of", "inbox").get("count"));
        }
    }

    @Test
    void theLadderShowsTheSubscribersMessagesInBothDirectionsWhileItIsOpen() {
        try (WebPhone phone = join()) {
            phone.say("{\"do\":\"ladder\",\"state\":\"on\"}");
            assertEquals(
                    "up",
                    phone.expect("layer3", "name", "Location Updating Request").get("direction"));
            assertEquals(
                    "down",
                    phone.expect("layer3", "name", "Location Updating Accept").get("direction"));
            phone.say("{\"do\":\"dial\",\"number\":\"5550200\"}");
            assertEquals("up", phone.expect("layer3", "name", "Setup").get("direction"));
            assertEquals("down", phone.expect("layer3", "name", "Connect").get("direction"));
            phone.expect("connected");
            phone.say("{\"do\":\"ladder\",\"state\":\"off\"}");
            phone.say("{\"do\":\"hangup\"}");
            phone.expectBefore("layer3", "released");
        }
    }

    @Test
    void aCutConnectionEndsTheCallAndTheTokenBringsTheNumberBackWithWhatCameMeanwhile() {
        WebPhone phone = new WebPhone(port, JOIN);
        Map<String, Object> welcome = phone.expect("welcome");
        phone.expect("registered");
        String number = welcome.get("number").toString();
        assertEquals(String.valueOf(Long.parseLong(number) - 5550110), welcome.get("place"));
        assertEquals("50", welcome.get("places"));
        RunningProgram other = scenario.phone("5550101");
        other.say("sms " + number + " before").expect("sms-sent");
        phone.expect("sms");
        phone.say("{\"do\":\"dial\",\"number\":\"5550200\"}");
        phone.expect("connected");
        phone.cut();
        gateway.expect("left", "number", number);
        robot.expect("released", "cause", "16");

        other.say("sms " + number + " meanwhile").expect("sms-sent");
        try (WebPhone again =
                new WebPhone(port, "{\"key\":\"word\",\"token\":\"" + welcome.get("token") + "\",\"name\":\"Ana\"}")) {
            assertEquals(number, again.expect("welcome").get("number"));
            assertEquals("before", again.expect("message").get("text"));
            assertEquals("meanwhile", again.expect("sms").get("text"));
            gateway.expect("joined", "number", number, "name", "Ana");
            assertEquals(
                    "idle",
                    gateway.say("users").expect("user", "number", number).field("state"));
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"key\":\"other\"}|4001",
                "{}|4001",
                "hello|1008",
                "[]|1008",
            })
    void aPageWithoutTheKeyIsClosed(String first, int code) throws Exception {
        try (WebPhone phone = new WebPhone(port, first)) {
            assertEquals(code, phone.closeCode());
        }
    }

    @Test
    void guessesOfTheKeyAreSlowedForTheirAddressAlsoIfOneIsRight() throws Exception {
        String guessed = scenario.gateway().expect("ready").field("web");
        Set<Integer> codes = new TreeSet<>();
        for (int i = 0; i < 20; i++) {
            try (WebPhone phone = new WebPhone(guessed, "{\"key\":\"guess" + i + "\"}")) {
                codes.add(phone.closeCode());
            }
        }
        assertEquals(Set.of(1013, 4001), codes);
        int right = 0;
        for (int i = 0; i < 50 && right != 429; i++) {
            robotsBy(guessed, "guess");
            right = robotsBy(guessed, "word");
        }
        assertEquals(429, right);
    }

    private static int robotsBy(String at, String key) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + at + "/robots"))
                .header("Authorization", "Bearer " + key)
                .build();
        return HttpClient.newHttpClient()
                .send(request, HttpResponse.BodyHandlers.discarding())
                .statusCode();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"do\":\"dial\",\"number\":\"none\"}|dial: ",
                "{\"do\":\"hangup\"}|hangup: there is no call",
                "{\"do\":\"answer\"}|answer: no call rings",
                "{\"do\":\"sms\",\"number\":\"5550200\",\"text\":\"\"}|sms: expected a text",
                "{\"do\":\"ladder\"}|ladder: expected the state on or off",
                "{\"do\":\"fly\"}|fly: expected dial, answer, hangup, sms, inbox or ladder",
                "{\"do\":|JSON, position 7: ",
            })
    void aWrongMessageIsAnsweredByAnError(String message, String answer) {
        try (WebPhone phone = join()) {
            phone.say(message);
            String text = phone.expect("error").get("text").toString();
            assertTrue(text.startsWith(answer), text);
        }
    }

    @Test
    void aFrameOfAnotherLengthClosesWith1003() throws Exception {
        try (WebPhone phone = join()) {
            phone.sendOctets(new byte[100]);
            assertEquals(1003, phone.closeCode());
        }
    }

    @Test
    void aLockedGatewayAdmitsNobodyNewAndADroppedPageIsClosed() throws Exception {
        try (WebPhone phone = new WebPhone(port, JOIN)) {
            String number = phone.expect("welcome").get("number").toString();
            // Commands are performed in order: after the list the lock holds.
            gateway.say("lock on").say("users").expect("end", "of", "users");
            try (WebPhone late = new WebPhone(port, JOIN)) {
                assertEquals(4003, late.closeCode());
                gateway.expect("refused", "kind", "web", "cause", "4003");
            }
            gateway.say("lock off").say("drop " + number);
            assertEquals(4004, phone.closeCode());
        }
    }

    @Test
    void aPageWithoutAFreeNumberIsClosed() throws Exception {
        String single =
                scenario.gateway("--numbers", "5550160-5550160").expect("ready").field("web");
        try (WebPhone phone = new WebPhone(single, JOIN)) {
            phone.expect("welcome");
            try (WebPhone late = new WebPhone(single, JOIN)) {
                assertEquals(4002, late.closeCode());
            }
        }
    }

    @Test
    void aPageThatComesBackBeforeItsConnectionHasEndedHasLostItsCall() throws Exception {
        WebPhone phone = new WebPhone(port, JOIN);
        Map<String, Object> welcome = phone.expect("welcome");
        phone.expect("registered");
        phone.say("{\"do\":\"dial\",\"number\":\"5550200\"}");
        phone.expect("connected");
        try (WebPhone again = new WebPhone(port, "{\"key\":\"word\",\"token\":\"" + welcome.get("token") + "\"}")) {
            assertEquals(welcome.get("number"), again.expect("welcome").get("number"));
            assertEquals(4000, phone.closeCode());
            robot.expect("released", "cause", "16");
            again.say("{\"do\":\"hangup\"}");
            assertEquals("hangup: there is no call", again.expect("error").get("text"));
        }
    }

    @ParameterizedTest
    @CsvSource({"5550200,", "5550200,--class=2"})
    void theDemoPrintsTheLinkByWhichABrowserReachesItsRobot(String number, String more) throws Exception {
        RunningProgram demo = scenario.headless(
                "demo",
                "simgsm-center",
                List.of("--demo", "--port", "0", "--web", "0"),
                more == null ? new String[0] : new String[] {more});
        URI link = URI.create(demo.expect("ready").field("link"));
        try (WebPhone phone =
                new WebPhone(String.valueOf(link.getPort()), "{\"key\":\"" + link.getFragment() + "\"}")) {
            phone.expect("registered");
            phone.say("{\"do\":\"dial\",\"number\":\"" + number + "\"}");
            phone.expect("connected");
            phone.expect("tone", "key", "1");
        }
        assertEquals(0, demo.quit());
    }

    private HttpResponse<String> get(String path, String key) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + path))
                .header("Authorization", "Bearer " + key)
                .build();
        return HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofString());
    }

    @ParameterizedTest
    @CsvSource({
        "/,text/html",
        "/link.html,text/html",
        "/phone.css,text/css",
        "/phone.js,text/javascript",
        "/sound.js,text/javascript",
        "/icon.svg,image/svg+xml",
        "/words-es.json,application/json"
    })
    void thePagesFilesAreServedToEverybody(String path, String type) throws Exception {
        HttpResponse<String> answer = get(path, "");
        assertEquals(200, answer.statusCode());
        assertTrue(answer.headers().firstValue("Content-Type").orElse("").startsWith(type));
    }

    @Test
    void theRobotIsShownToThoseWhoHaveTheKey() throws Exception {
        assertEquals(401, get("/robots", "other").statusCode());
        assertTrue(get("/robots", "word").body().contains("\"name\":\"robot\""));
        assertTrue(get("/link.svg", "word").body().contains("/#word"));
        assertTrue(get("/users", "word").body().startsWith("["));
        assertTrue(get("/robots/robot/map.svg", "word").body().startsWith("<svg "));
        assertTrue(get("/robots/robot/lane.svg", "word").body().startsWith("<svg "));
        assertEquals(404, get("/robots/none/map.svg", "word").statusCode());
        assertNotEquals(200, get("/robots/robot/../../x", "word").statusCode());
    }
}
