package simgsm.web;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pages on a port of this machine, asked octet by octet. */
@Timeout(60)
class WebPagesTest {
    private static final String POLICY = "default-src 'none'";
    private static final String PAGE = "<html>".repeat(50) + "\u00f1</html>";
    private static final byte[] PICTURE = {(byte) 0xff, (byte) 0xd8, 0, 1};

    /** A page of each kind, and each way to fail. */
    private static final class Pages extends WebPages {
        private final PageBody page = new PageBody("", new PageBody.Part(PAGE), "");

        Pages() {
            super(POLICY);
        }

        @Override
        protected WebResponse answer(WebRequest request, List<String> parts)
                throws IOException, InterruptedException, RequestException {
            return switch (parts.isEmpty() ? "page" : parts.get(0)) {
                case "page" -> page.answer(request);
                case "parts" -> WebResponse.json(parts + request.query());
                case "html" -> WebResponse.html("\u00f1");
                case "jpeg" -> WebResponse.jpeg(PICTURE);
                case "stream" -> WebResponse.stream("text/plain", new Endless());
                case "large" -> WebResponse.json("a".repeat(30_000_000));
                case "busy" -> throw new IllegalStateException("the program does not answer");
                case "fault" -> throw new UnsupportedOperationException("on purpose");
                case "interrupted" -> throw new InterruptedException("on purpose");
                default -> throw RequestException.notFound(request.path(), "/ or /parts");
            };
        }
    }

    /** Three words, or more and more if they are not read. */
    private static final class Endless implements WebResponse.Stream {
        private static final AtomicInteger ENDED = new AtomicInteger();

        @Override
        public void writeTo(OutputStream out) throws IOException {
            out.write("one two three".getBytes(StandardCharsets.US_ASCII));
        }

        @Override
        public void close() {
            ENDED.incrementAndGet();
        }
    }

    /** What came back; {@code headers} by their names in small letters. */
    private record Answer(String statusLine, Map<String, String> headers, byte[] body) {
        String text() {
            return new String(body, StandardCharsets.UTF_8);
        }

        void expect(int status, String text) {
            assertEquals(status, Integer.parseInt(statusLine.split(" ")[1]), statusLine);
            assertEquals(text, text());
        }
    }

    private WebPort port;

    @BeforeEach
    void open() throws IOException {
        port = new WebPort(InetAddress.getLoopbackAddress(), 0, new Pages());
        port.start();
    }

    @AfterEach
    void close() {
        port.close();
    }

    /** All that the server sends before it closes. */
    private byte[] octetsOf(String request) throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port.port())) {
            socket.getOutputStream().write(request.getBytes(StandardCharsets.ISO_8859_1));
            return socket.getInputStream().readAllBytes();
        }
    }

    private Answer ask(String method, String path, String... headers) throws IOException {
        String lines = Arrays.stream(headers).map(header -> header + "\r\n").reduce("", String::concat);
        return parsed(octetsOf(method + " " + path + " HTTP/1.1\r\n" + lines + "Connection: close\r\n\r\n"));
    }

    private static Answer parsed(byte[] all) {
        String text = new String(all, StandardCharsets.ISO_8859_1);
        int end = text.indexOf("\r\n\r\n");
        assertTrue(end > 0, text);
        String[] head = text.substring(0, end).split("\r\n");
        Map<String, String> found = new HashMap<>();
        for (int i = 1; i < head.length; i++) {
            String[] field = head[i].split(": *", 2);
            found.merge(field[0].toLowerCase(Locale.ROOT), field[1], (one, other) -> one + ", " + other);
        }
        return new Answer(head[0], found, Arrays.copyOfRange(all, end + 4, all.length));
    }

    private Answer get(String path, String... headers) throws IOException {
        return ask("GET", path, headers);
    }

    @Test
    void aPathIsCutIntoItsDecodedSegments() throws IOException {
        get("/parts/a%20b/1+1/%C3%B1/?and=%20this").expect(200, "[parts, a b, 1+1, \u00f1]and=%20this");
        assertEquals("1%2B1%20%C3%B1", UrlPaths.encoded("1+1 \u00f1"));
    }

    @Test
    void everyAnswerSaysItsTypeAndWhatItMayLoad() throws IOException {
        Map<String, String> headers = get("/parts").headers();
        assertEquals("application/json", headers.get("content-type"));
        assertEquals(POLICY, headers.get("content-security-policy"));
        assertEquals("nosniff", headers.get("x-content-type-options"));
        assertEquals("no-store", headers.get("cache-control"));
    }

    @Test
    void textsAreUtf8AndPicturesAreAsTheyAre() throws IOException {
        Answer html = get("/html");
        html.expect(200, "\u00f1");
        assertEquals("text/html; charset=utf-8", html.headers().get("content-type"));
        Answer picture = get("/jpeg");
        assertEquals("image/jpeg", picture.headers().get("content-type"));
        assertArrayEquals(PICTURE, picture.body());
    }

    @Test
    void headIsGetWithoutTheBody() throws IOException {
        Answer head = ask("HEAD", "/parts");
        head.expect(200, "");
        assertEquals("7", head.headers().get("content-length"));
    }

    @Test
    void aStreamEndsWithTheConnection() throws IOException {
        int ended = Endless.ENDED.get();
        Answer stream = get("/stream");
        stream.expect(200, "one two three");
        assertEquals("text/plain", stream.headers().get("content-type"));
        assertEquals("close", stream.headers().get("connection"));
        assertNull(stream.headers().get("content-length"));
        ask("HEAD", "/stream").expect(200, "");
        assertEquals(ended + 2, Endless.ENDED.get());
    }

    @Test
    void anUnknownPathIs404WithWhatIsExpected() throws IOException {
        get("/nowhere/%22").expect(404, "{\"error\":\"nothing at /nowhere/%22, expected / or /parts\"}");
    }

    @Test
    void aLongPathIsNotSentBackAtLength() throws IOException {
        String path = "/" + "a".repeat(1000);
        get(path).expect(404, "{\"error\":\"nothing at " + path.substring(0, 200) + "..., expected / or /parts\"}");
    }

    @Test
    void octetsThatAreNoUtf8AreReplacedAndHalfAnEscapeIs400() throws IOException {
        get("/parts/%ff").expect(200, "[parts, \ufffd]");
        expectError(get("/parts/%4"), 400, "malformed path /parts/%4, expected %XX");
    }

    @ParameterizedTest
    @ValueSource(strings = {"POST", "PUT", "DELETE", "OPTIONS", "get"})
    void otherMethodsAre405(String method) throws IOException {
        Answer answer = ask(method, "/parts");
        answer.expect(405, "{\"error\":\"method " + method + " is not allowed, expected GET or HEAD\"}");
        assertEquals("GET, HEAD", answer.headers().get("allow"));
    }

    @Test
    void aProgramThatDoesNotAnswerIs503() throws IOException {
        get("/busy").expect(503, "{\"error\":\"the program does not answer\"}");
    }

    @Test
    void aFaultIs500AndTheNextRequestIsAnswered() throws IOException {
        get("/fault").expect(500, "{\"error\":\"the request cannot be answered; the log has the reason\"}");
        assertEquals(0, octetsOf("GET /interrupted HTTP/1.1\r\n\r\n").length);
        get("/parts").expect(200, "[parts]");
    }

    // ---- requests that are none: in the same form, which the JDK's server does not have ----

    private Answer answerTo(String request) throws IOException {
        return parsed(octetsOf(request));
    }

    private static void expectError(Answer answer, int status, String text) {
        answer.expect(status, "{\"error\":\"" + text + "\"}");
        assertEquals("application/json", answer.headers().get("content-type"));
        assertEquals(POLICY, answer.headers().get("content-security-policy"));
        assertEquals("nosniff", answer.headers().get("x-content-type-options"));
    }

    @ParameterizedTest
    @CsvSource({
        "//parts, 404, 'nothing at //parts, expected / or /parts'",
        "/%zz, 400, 'malformed path /%zz, expected %XX'",
        "/parts/%4, 400, 'malformed path /parts/%4, expected %XX'",
        "parts, 400, 'malformed path parts, expected /...'",
        "ftp://localhost/parts, 400, 'malformed path ftp://localhost/parts, expected /...'",
        "/#parts, 400, 'malformed path /#parts, expected /...'"
    })
    void aPathThatIsNone(String path, int status, String text) throws IOException {
        expectError(get(path), status, text);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "GET /parts",
                "hello",
                "GET  ",
                "G@T /parts HTTP/1.1",
                "GET /p arts HTTP/1.1",
                "GET /\u00f1 HTTP/1.1"
            })
    void aRequestLineThatIsNone(String line) throws IOException {
        expectError(
                answerTo(line + "\r\n\r\n"), 400, "malformed request line " + line + ", expected METHOD PATH HTTP/1.1");
    }

    @Test
    void aVersionOfLaterTimesIs505() throws IOException {
        expectError(answerTo("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"), 505, "expected HTTP/1.1");
    }

    @ParameterizedTest
    @ValueSource(strings = {"no colon", " folded: line", "Name : value", ": value", "A: \u0001"})
    void aHeaderFieldThatIsNone(String field) throws IOException {
        Answer answer = answerTo("GET /parts HTTP/1.1\r\n" + field + "\r\n\r\n");
        assertTrue(answer.statusLine().startsWith("HTTP/1.1 400 Bad Request"), answer.statusLine());
        assertTrue(answer.text().startsWith("{\"error\":\"malformed header field "), answer.text());
    }

    @ParameterizedTest
    @ValueSource(ints = {65_537, 3_000_000})
    void anOverLongLineIsRefusedAndTheAnswerArrives(int octets) throws IOException {
        expectError(
                answerTo("GET /" + "a".repeat(octets) + " HTTP/1.1\r\n\r\n"),
                414,
                "the request line is too long, expected at most 65536 octets");
    }

    @Test
    void tooMuchHeaderIsRefused() throws IOException {
        expectError(
                answerTo("GET /parts HTTP/1.1\r\n" + ("A: " + "a".repeat(1000) + "\r\n").repeat(66) + "\r\n"),
                431,
                "the header is too long, expected at most 65536 octets");
    }

    @Test
    void aBodyIsNotReadAndTheAnswerArrives() throws IOException {
        answerTo("GET /parts HTTP/1.1\r\nContent-Length: 900000\r\n\r\n" + "b".repeat(900_000))
                .expect(200, "[parts]");
        answerTo("POST /parts HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n5\r\nhello\r\n0\r\n\r\n")
                .expect(405, "{\"error\":\"method POST is not allowed, expected GET or HEAD\"}");
    }

    @Test
    void requestsFollowOneAnotherOnOneConnection() throws IOException {
        String both = new String(
                octetsOf("GET /parts HTTP/1.1\nHost: localhost\n\n"
                        + "\r\nHEAD /html HTTP/1.1\r\n\r\n"
                        + "GET /jpeg/%zz HTTP/1.1\r\n\r\n"
                        + "GET http://127.0.0.1?q HTTP/1.0\r\nHost: evil.example\r\nAccept-Encoding: identity\r\n\r\n"
                        + "GET /parts HTTP/1.1\r\n\r\n"),
                StandardCharsets.UTF_8);
        String[] answers = both.split("(?=HTTP/1\\.1 )");
        assertEquals(4, answers.length, both);
        assertTrue(answers[0].endsWith("\r\n\r\n[parts]"), both);
        assertTrue(answers[1].contains("Content-Length: 2\r\n") && answers[1].endsWith("\r\n\r\n"), both);
        assertTrue(answers[2].startsWith("HTTP/1.1 400 "), both);
        assertTrue(answers[3].contains("Connection: close") && answers[3].endsWith(PAGE), both);
    }

    @Test
    void aClientThatTakesNothingLosesItsConnection() throws IOException {
        try (WebPort impatient = new WebPort(InetAddress.getLoopbackAddress(), 0, new Pages(), 100_000_000);
                Socket stuck = new Socket()) {
            impatient.start();
            stuck.setReceiveBufferSize(4096);
            stuck.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), impatient.port()));
            byte[] request = "GET /large HTTP/1.1\r\n\r\n".getBytes(StandardCharsets.US_ASCII);
            stuck.getOutputStream().write(request);
            assertEquals('H', stuck.getInputStream().read());
            // nothing is read until the other end resets the connection, which a write finds out
            assertThrows(IOException.class, () -> {
                while (true) {
                    stuck.getOutputStream().write(request);
                }
            });
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"localhost", "LOCALHOST:8080", "127.0.0.1", "192.168.1.20:80", "[::1]:8080", "[fe80::1%252]"})
    void aRequestMayNameThisMachine(String host) throws IOException {
        get("/parts", "Host: " + host).expect(200, "[parts]");
    }

    @Test
    void aRequestMayNameThisMachineByItsOwnName() throws IOException {
        get("/parts", "Host: " + InetAddress.getLocalHost().getHostName() + ":80")
                .expect(200, "[parts]");
    }

    @ParameterizedTest
    @ValueSource(strings = {"evil.example", "localhost.evil.example:80", "127.0.0.1.evil.example", "localhost:80:80"})
    void aRequestThatNamesAnotherMachineIs403(String host) throws IOException {
        Answer answer = get("/parts", "Host: " + host, "Origin: http://localhost");
        answer.expect(
                403, "{\"error\":\"the host of the request is not this machine, expected localhost or an address\"}");
        assertNull(answer.headers().get("access-control-allow-origin"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"http://localhost", "https://localhost:5173", "http://127.0.0.1:80", "http://[::1]:3000"})
    void pagesOfThisMachineMayRead(String origin) throws IOException {
        Map<String, String> headers = get("/parts", "Origin: " + origin).headers();
        assertEquals(origin, headers.get("access-control-allow-origin"));
        assertEquals("Origin", headers.get("vary"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"https://evil.example", "http://localhost.evil.example", "null", "file://localhost"})
    void otherPagesMayNot(String origin) throws IOException {
        Answer answer = get("/parts", "Origin: " + origin);
        answer.expect(200, "[parts]");
        assertNull(answer.headers().get("access-control-allow-origin"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"gzip", "deflate, gzip;q=0.5", "*", "br,gzip"})
    void aPageIsCompressedForWhoTakesThat(String encodings) throws IOException {
        Answer answer = get("/", "Accept-Encoding: " + encodings);
        assertEquals("gzip", answer.headers().get("content-encoding"));
        assertEquals("Accept-Encoding", answer.headers().get("vary").replace("Origin, ", ""));
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(answer.body()))) {
            assertEquals(PAGE, new String(in.readAllBytes(), StandardCharsets.UTF_8));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"identity", "gzip;q=0", "gzip; q=0.000, br", "xgzip"})
    void aPageIsPlainForWhoDoesNot(String encodings) throws IOException {
        Answer answer = get("/", "Accept-Encoding: " + encodings);
        answer.expect(200, PAGE);
        assertNull(answer.headers().get("content-encoding"));
    }

    @Test
    void aPageTheClientHasIsNotSentAgain() throws IOException {
        Answer first = get("/");
        first.expect(200, PAGE);
        assertEquals("no-cache", first.headers().get("cache-control"));
        String tag = first.headers().get("etag");
        Answer again = get("/", "If-None-Match: " + tag, "Accept-Encoding: gzip");
        again.expect(304, "");
        assertEquals(tag, again.headers().get("etag"));
        get("/", "If-None-Match: W/\"another\"").expect(200, PAGE);
    }

    @Test
    void halfARequestIsClosedAndHoldsNobodyUp() throws IOException {
        try (Socket half = new Socket(InetAddress.getLoopbackAddress(), port.port())) {
            half.getOutputStream().write("GET /parts HTTP/1.1\r\nHost: local".getBytes(StandardCharsets.US_ASCII));
            get("/parts").expect(200, "[parts]");
            assertEquals(-1, half.getInputStream().read());
        }
    }

    @Test
    void aPortThatIsTakenIsNamed() {
        IOException refused = assertThrows(
                IOException.class, () -> new WebPort(InetAddress.getLoopbackAddress(), port.port(), new Pages()));
        assertTrue(refused.getMessage().startsWith("HTTP port " + port.port() + ": "), refused.getMessage());
    }

    @Test
    void thePortSaysWhereItIs() throws IOException {
        String loopback = InetAddress.getLoopbackAddress().getHostAddress();
        assertEquals("http://" + loopback + ":" + port.port() + "/", port.url());
        try (WebPort all = new WebPort(InetAddress.getByName("::"), 0, new Pages())) {
            assertTrue(all.url().startsWith("http://[0:0:0:0:0:0:0:0]:"), all.url());
        }
    }
}
