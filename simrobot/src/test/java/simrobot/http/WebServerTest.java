package simrobot.http;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.HttpURLConnection;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.zip.GZIPInputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.OrderReport;

/** The web server over a simulation that only the test moves. */
class WebServerTest {
    private static final String ODD = "\u00f1a+nd\u00fa 1/<2>&\"3\"%";
    private static final String ODD_ENCODED = "%C3%B1a+nd%C3%BA%201%2F%3C2%3E%26%223%22%25";
    private static final int PATIENCE_MILLIS = 30_000;

    private final Simulation simulation = new Simulation(World.of("wall & co", List.of(new Segment(2, -3, 2, 3))), 1);
    private WebServer server;

    @BeforeEach
    void start() throws IOException {
        simulation.addRobot("ann", new Position(0, 0), 0);
        simulation.addRobot(ODD, new Position(0, 1), Math.PI / 2);
        server = open(Locale.ENGLISH);
    }

    private WebServer open(Locale language) throws IOException {
        WebServer opened = new WebServer(
                InetAddress.getLoopbackAddress(),
                0,
                language,
                source(() -> {
                    synchronized (simulation) {
                        return simulation.snapshot();
                    }
                }),
                Optional.empty());
        opened.start();
        return opened;
    }

    private static WebSource source(Supplier<SimulationSnapshot> scenes) {
        return new WebSource() {
            @Override
            public SimulationSnapshot scene() {
                return scenes.get();
            }

            @Override
            public String number(String robot) {
                return robot.equals("ann") ? "5550200" : "";
            }

            @Override
            public boolean order(String robot, String operator, String keys, Consumer<OrderReport> follower) {
                throw new AssertionError("no keys are given");
            }

            @Override
            public String modem(String robot) {
                return robot.equals("ann") ? "no-network" : "";
            }
        };
    }

    @AfterEach
    void stop() {
        server.close();
    }

    private HttpURLConnection ask(String method, String path) throws IOException {
        return ask(server, method, path);
    }

    private static HttpURLConnection ask(WebServer asked, String method, String path) throws IOException {
        HttpURLConnection connection = (HttpURLConnection)
                new URL("http", InetAddress.getLoopbackAddress().getHostAddress(), asked.port(), path).openConnection();
        connection.setRequestMethod(method);
        connection.setConnectTimeout(PATIENCE_MILLIS);
        connection.setReadTimeout(PATIENCE_MILLIS);
        return connection;
    }

    private static String text(HttpURLConnection answer) throws IOException {
        try (InputStream in = answer.getResponseCode() < 400 ? answer.getInputStream() : answer.getErrorStream()) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    // ---- the page --------------------------------------------------------------------------------------------------

    @Test
    void thePageShowsMapRobotsAndCamerasAndTakesNothingFromElsewhere() throws Exception {
        HttpURLConnection answer = ask("GET", "/");
        String page = text(answer);
        assertEquals(200, answer.getResponseCode());
        assertEquals("text/html; charset=utf-8", answer.getContentType());
        assertTrue(page.startsWith("<!DOCTYPE html>\n<html lang=\"en\">"), page);
        assertTrue(page.contains("aria-label=\"Map of the world wall &amp; co with its robots\""), page);
        // the wall from (2, -3) to (2, 3) on 20 m of floor, 43.2 pixels a metre
        assertTrue(page.contains("M480 609.6L480 350.4"), page);
        assertTrue(page.contains("src=\"/robots/ann/camera.jpg\""), page);
        assertTrue(page.contains("src=\"/robots/" + ODD_ENCODED.replace("+", "%2B") + "/camera.jpg\""), page);
        assertTrue(page.contains(">\u00f1a+nd\u00fa 1/&lt;2&gt;&amp;&quot;3&quot;%</a>"), page);
        assertFalse(page.contains("://") || page.contains("{{"), page);
        assertTrue(page.contains("prefers-color-scheme: dark"), page);
    }

    @Test
    void thePageSpeaksSpanishToo() throws Exception {
        try (WebServer spanish = open(Locale.forLanguageTag("es"))) {
            String page = text(ask(spanish, "GET", "/"));
            assertTrue(page.contains("<html lang=\"es\">"), page);
            assertTrue(page.contains("C\u00e1maras"), page);
        }
    }

    @Test
    void aRobotsMapEndsAtTheWallsAroundItAndFitsAPhone() throws Exception {
        String map = text(ask("GET", "/robots/ann/map.svg"));
        // 12 m to the wall, but 20 m from south to north, in 320 pixels
        assertTrue(
                map.startsWith("<svg ") && map.contains("data-scale=\"" + "16.000000" + "\""), map.substring(0, 200));
    }

    // ---- status ----------------------------------------------------------------------------------------------------

    @Test
    void allRobotsAreOneJsonList() throws Exception {
        HttpURLConnection answer = ask("GET", "/robots");
        String json = text(answer);
        assertEquals("application/json", answer.getContentType());
        assertTrue(json.startsWith("[{\"name\":\"ann\",\"number\":\"5550200\",\"status\":\"Stopped\","), json);
        assertTrue(json.contains("\"modem\":\"no-network\","), json);
        assertTrue(json.contains("},{\"name\":\"\u00f1a+nd\u00fa 1/<2>&\\\"3\\\"%\""), json);
        assertTrue(json.endsWith("}]"), json);
    }

    @Test
    void aRobotsStatusTellsWhereItIsAndHowItIs() throws Exception {
        SimulatedRobot ann = simulation.robot("ann").orElseThrow();
        synchronized (simulation) {
            ann.drive().move(5);
            simulation.run(1500);
        }
        String json = text(ask("GET", "/robots/ann"));
        for (String expected : List.of(
                "\"status\":\"Collision\"",
                "\"x\":1.7500,\"y\":0.0000,\"heading\":0.00",
                "\"stalled\":true",
                "\"front\":[false,false,true,false,false]",
                "\"odometry\":{\"x\":1.7500,",
                "\"world\":\"wall & co\",\"time\":15.00",
                "\"camera\":\"/robots/ann/camera.jpg\"")) {
            assertTrue(json.contains(expected), expected + " in " + json);
        }
        assertTrue(json.matches(".*\"sonar\":\\[([0-9]+,){15}[0-9]+].*"), json);
    }

    @Test
    void aNameOfAnyCharactersIsReadFromItsPath() throws Exception {
        String json = text(ask("GET", "/robots/" + ODD_ENCODED));
        assertTrue(json.contains("\"heading\":90.00"), json);
        assertEquals(200, ask("GET", "/robots/" + ODD_ENCODED + "/camera.jpg").getResponseCode());
    }

    // ---- what is refused -------------------------------------------------------------------------------------------

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/robots/bob",
                "/robots/bob/camera.jpg",
                "/robots/bob/camera.mjpg",
                "/robots/ANN",
                "/robots/an%6e%6e"
            })
    void anUnknownRobotIsNotFoundAndTheErrorIsJson(String path) throws Exception {
        HttpURLConnection answer = ask("GET", path);
        assertEquals(404, answer.getResponseCode());
        assertEquals("application/json", answer.getContentType());
        String error = text(answer);
        assertTrue(error.startsWith("{\"error\":\"no robot ") && error.contains("expected one of ann"), error);
    }

    @ParameterizedTest
    @ValueSource(strings = {"/nothing", "/robots/ann/camera.png", "/robots/ann/camera.jpg/more", "/robots//ann"})
    void anyOtherPathIsNotFound(String path) throws Exception {
        HttpURLConnection answer = ask("GET", path);
        assertEquals(404, answer.getResponseCode());
    }

    @ParameterizedTest
    @CsvSource({"POST, /", "PUT, /robots", "DELETE, /robots/ann", "OPTIONS, /robots", "POST, /robots/ann/camera.mjpg"})
    void aMethodOtherThanReadingIsRefusedWithTheAllowedOnes(String method, String path) throws Exception {
        HttpURLConnection answer = ask(method, path);
        assertEquals(405, answer.getResponseCode());
        assertEquals("GET, HEAD", answer.getHeaderField("Allow"));
        assertTrue(text(answer).contains("expected GET or HEAD"));
    }

    @Test
    void headAnswersAsGetWithoutItsBody() throws Exception {
        for (String path : List.of("/", "/robots", "/robots/ann", "/robots/ann/camera.jpg")) {
            int length = text(ask("GET", path)).getBytes(StandardCharsets.UTF_8).length;
            HttpURLConnection answer = ask("HEAD", path);
            assertEquals(200, answer.getResponseCode());
            assertEquals("", text(answer));
            assertTrue(path.endsWith(".jpg") || answer.getContentLength() == length, path);
        }
        HttpURLConnection stream = ask("HEAD", "/robots/ann/camera.mjpg");
        assertEquals("multipart/x-mixed-replace; boundary=simrobot-frame", stream.getContentType());
        assertEquals("", text(stream));
        assertEquals(404, ask("HEAD", "/robots/bob").getResponseCode());
    }

    // ---- cameras ---------------------------------------------------------------------------------------------------

    @Test
    void aPictureIsAJpegOfTheCamerasSize() throws Exception {
        HttpURLConnection answer = ask("GET", "/robots/ann/camera.jpg?any=thing");
        assertEquals("image/jpeg", answer.getContentType());
        assertEquals("no-store", answer.getHeaderField("Cache-Control"));
        assertEquals(320, ImageIO.read(answer.getInputStream()).getWidth());
    }

    /** A stream's client: reads it part by part, or does not read at all. */
    private final class Watcher implements AutoCloseable {
        private final Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
        private final DataInputStream in = new DataInputStream(new BufferedInputStream(socket.getInputStream()));

        Watcher(String query) throws IOException {
            socket.setSoTimeout(PATIENCE_MILLIS);
            String question = "GET /robots/ann/camera.mjpg" + query + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
            socket.getOutputStream().write(question.getBytes(StandardCharsets.US_ASCII));
        }

        @SuppressWarnings("deprecation")
        String line() throws IOException {
            return in.readLine();
        }

        /** All lines up to the next empty one. */
        List<String> head() throws IOException {
            List<String> lines = new ArrayList<>();
            for (String line = line(); line != null && !line.isEmpty(); line = line()) {
                lines.add(line);
            }
            return lines;
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    /** The chunks of the transfer are taken off by the JDK's own client. */
    private static byte[] part(DataInputStream in) throws IOException {
        int length = -1;
        for (String line = lineOf(in); !line.isEmpty(); line = lineOf(in)) {
            if (line.startsWith("Content-Length: ")) {
                length = Integer.parseInt(line.substring(16));
            }
        }
        byte[] jpeg = new byte[length];
        in.readFully(jpeg);
        assertEquals("", lineOf(in));
        assertEquals("--simrobot-frame", lineOf(in));
        return jpeg;
    }

    @SuppressWarnings("deprecation")
    private static String lineOf(DataInputStream in) throws IOException {
        String line = in.readLine();
        return line == null ? "(end)" : line;
    }

    @Test
    void aStreamSendsAPictureForEachThingThatMoves() throws Exception {
        HttpURLConnection answer = ask("GET", "/robots/ann/camera.mjpg?fps=20");
        assertEquals("multipart/x-mixed-replace; boundary=simrobot-frame", answer.getContentType());
        try (DataInputStream in = new DataInputStream(answer.getInputStream())) {
            assertEquals("--simrobot-frame", lineOf(in));
            byte[] first = part(in);
            assertEquals(240, ImageIO.read(new ByteArrayInputStream(first)).getHeight());
            synchronized (simulation) {
                simulation.robot("ann").orElseThrow().place(0, 0, 1);
            }
            byte[] second = part(in);
            while (Arrays.equals(first, second)) {
                second = part(in); // on a slow machine the first is repeated before the robot has moved
            }
            assertArrayEquals(second, part(in), "and the same again, now and then");
        }
    }

    @Test
    void aStreamEndsWhenItsRobotGoes() throws Exception {
        HttpURLConnection answer = ask("GET", "/robots/ann/camera.mjpg");
        try (DataInputStream in = new DataInputStream(answer.getInputStream())) {
            lineOf(in);
            part(in);
            synchronized (simulation) {
                simulation.removeRobot(simulation.robot("ann").orElseThrow());
            }
            assertEquals("(end)", lineOf(in));
        }
    }

    @Test
    void clientsThatReadNothingDelayNoOthersAndTheirNumberIsLimited() throws Exception {
        List<Watcher> watchers = new ArrayList<>();
        try {
            for (int i = 0; i < CameraStreams.MOST; i++) {
                Watcher watcher = new Watcher("?fps=20");
                watchers.add(watcher);
                assertEquals("HTTP/1.1 200 OK", watcher.line());
            }
            HttpURLConnection tooMany = ask("GET", "/robots/ann/camera.mjpg");
            assertEquals(503, tooMany.getResponseCode());
            assertEquals("5", tooMany.getHeaderField("Retry-After"));
            assertTrue(text(tooMany).contains("all 16 streams are taken"));
            assertEquals(200, ask("GET", "/robots/ann/camera.jpg").getResponseCode());
        } finally {
            for (Watcher watcher : watchers) {
                watcher.close();
            }
        }
        assertEquals(200, statusWhenAStreamIsFree(server));
    }

    /**
     * Asks for a stream every 50 ms: one notices by its next picture that its client has gone or reads nothing. On a busy machine
     * it takes minutes until pictures have filled what the sockets hold.
     */
    private int statusWhenAStreamIsFree(WebServer asked) throws Exception {
        int status = 503;
        for (int i = 0; i < 6_000 && status == 503; i++) {
            HttpURLConnection viewer = ask(asked, "GET", "/robots/ann/camera.mjpg");
            status = viewer.getResponseCode();
            viewer.disconnect();
            synchronized (simulation) {
                simulation.robot("ann").orElseThrow().place(0, 0, i);
                simulation.wait(50);
            }
        }
        return status;
    }

    @ParameterizedTest
    @CsvSource({"?fps=1, 200", "?fps=20, 200", "?fps=0, 400", "?fps=21, 400", "?fps=x, 400", "?other=1, 200"})
    void theRateIsWithinBounds(String query, int status) throws Exception {
        HttpURLConnection answer = ask("HEAD", "/robots/ann/camera.mjpg" + query);
        assertEquals(status, answer.getResponseCode());
    }

    // ---- hostile clients -------------------------------------------------------------------------------------------

    @Test
    void halfQuestionsAndRubbishDoNotHoldUpOthers() throws Exception {
        List<Socket> clients = new ArrayList<>();
        try {
            for (String rubbish :
                    List.of("GET / HT", "\0\0\0\0\r\n\r\n", "GET /%zz HTTP/1.1\r\n\r\n", "\r\n\r\n\r\n", "")) {
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
                clients.add(socket);
                socket.getOutputStream().write(rubbish.getBytes(StandardCharsets.US_ASCII));
                assertEquals(200, ask("GET", "/robots/ann").getResponseCode());
            }
        } finally {
            for (Socket client : clients) {
                client.close();
            }
        }
        assertEquals(200, ask("GET", "/").getResponseCode());
    }

    // ---- viewers and clients that hold others up
    // ---------------------------------------------------------------------

    private Socket raw(WebServer asked, String request) throws IOException {
        Socket socket = new Socket();
        socket.setReceiveBufferSize(4096);
        socket.setSoTimeout(PATIENCE_MILLIS);
        socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), asked.port()), PATIENCE_MILLIS);
        socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
        return socket;
    }

    /** A picture of many edges is long, so that few of them fill what the sockets of a connection hold. */
    private static Simulation amongPosts() {
        List<Segment> posts = new ArrayList<>();
        for (int i = 0; i < 400; i++) {
            double angle = i * 2.4;
            double near = 1 + i / 200.0;
            posts.add(new Segment(
                    near * Math.cos(angle),
                    near * Math.sin(angle),
                    (near + 0.1) * Math.cos(angle + 0.02),
                    (near + 0.1) * Math.sin(angle + 0.02)));
        }
        Simulation simulation = new Simulation(World.of("posts", posts), 1);
        simulation.addRobot("ann", new Position(0, 0), 0).drive().setTurnSpeed(1);
        return simulation;
    }

    @Test
    void viewersThatStopReadingLoseTheirStreamsSoThatOthersGetOne() throws Exception {
        Simulation posts = amongPosts();
        List<Socket> stuck = new ArrayList<>();
        try (WebServer impatient = new WebServer(
                InetAddress.getLoopbackAddress(),
                0,
                Locale.ENGLISH,
                source(() -> {
                    posts.run(5);
                    return posts.snapshot();
                }),
                Optional.empty(),
                100_000_000)) {
            impatient.start();
            for (int i = 0; i < CameraStreams.MOST; i++) {
                stuck.add(raw(impatient, "GET /robots/ann/camera.mjpg?fps=20 HTTP/1.1\r\nHost: localhost\r\n\r\n"));
                assertEquals('H', stuck.get(i).getInputStream().read());
            }
            assertEquals(200, statusWhenAStreamIsFree(impatient));
        } finally {
            for (Socket socket : stuck) {
                socket.close();
            }
        }
    }

    @Test
    void halfRequestsDoNotDelayOthers() throws Exception {
        List<Socket> half = new ArrayList<>();
        try {
            for (int i = 0; i < 100; i++) {
                half.add(raw(server, "GET /robots HTTP/1.1\r\nHost: local"));
            }
            assertEquals(200, ask("GET", "/robots").getResponseCode());
            for (Socket socket : half) {
                assertEquals(-1, socket.getInputStream().read(), "a half request is not answered");
            }
        } finally {
            for (Socket socket : half) {
                socket.close();
            }
        }
    }

    // ---- the page's compressed form
    // ------------------------------------------------------------------------------------

    @Test
    void thePageIsTheSameCompressedAndAnUnchangedOneIsNotSentAgain() throws Exception {
        String plain = text(ask("GET", "/"));
        HttpURLConnection answer = ask("GET", "/");
        answer.setRequestProperty("Accept-Encoding", "deflate, gzip");
        assertEquals("gzip", answer.getHeaderField("Content-Encoding"));
        try (InputStream in = new GZIPInputStream(answer.getInputStream())) {
            assertEquals(plain, new String(in.readAllBytes(), StandardCharsets.UTF_8));
        }
        HttpURLConnection again = ask("GET", "/");
        again.setRequestProperty("If-None-Match", answer.getHeaderField("ETag"));
        assertEquals(304, again.getResponseCode());
        simulation.robot("ann").orElseThrow().place(-1, 0, 0);
        int status = 304;
        // a scene may be 50 ms old
        while (status == 304) {
            HttpURLConnection moved = ask("GET", "/");
            moved.setRequestProperty("If-None-Match", answer.getHeaderField("ETag"));
            status = moved.getResponseCode();
        }
        assertEquals(200, status);
    }

    @ParameterizedTest
    @ValueSource(strings = {"gzip;q=0", "identity", "x-gzip2"})
    void aClientThatTakesNoGzipGetsNone(String encodings) throws Exception {
        HttpURLConnection answer = ask("GET", "/");
        answer.setRequestProperty("Accept-Encoding", encodings);
        assertNull(answer.getHeaderField("Content-Encoding"));
    }

    // ---- pages of others
    // -----------------------------------------------------------------------------------------------

    private String answerTo(String head) throws IOException {
        try (Socket socket = raw(server, head + "Connection: close\r\n\r\n")) {
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "localhost,200",
        "127.0.0.1:8080,200",
        "[::1]:80,200",
        "192.168.1.7,200",
        "evil.example,403",
        "localhost.evil.example,403"
    })
    void aRequestNamesThisMachine(String host, int status) throws Exception {
        String answer = answerTo("GET /robots HTTP/1.1\r\nHost: " + host + "\r\n");
        assertTrue(answer.startsWith("HTTP/1.1 " + status + " "), answer);
    }

    @ParameterizedTest
    @CsvSource({
        "http://localhost:8000,true",
        "http://127.0.0.1,true",
        "https://localhost,true",
        "https://evil.example,false",
        "http://localhost.evil.example,false",
        "null,false"
    })
    void aPageOfThisMachineMayReadAndOthersMayNot(String origin, boolean may) throws Exception {
        String answer = answerTo("GET /robots HTTP/1.1\r\nHost: localhost\r\nOrigin: " + origin + "\r\n");
        assertEquals(may, answer.toLowerCase(Locale.ROOT).contains("access-control-allow-origin: " + origin), answer);
    }

    @Test
    void aLongRequestIsNotSentBack() throws Exception {
        HttpURLConnection answer = ask("GET", "/" + "A/".repeat(30_000));
        assertEquals(404, answer.getResponseCode());
        assertTrue(text(answer).length() < 1000);
    }
}
