package simgsm.web;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpExchange;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
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
        protected Optional<WebResponse> answer(HttpExchange exchange, List<String> parts, String path)
                throws IOException, InterruptedException, RequestException {
            String first = parts.isEmpty() ? "" : parts.get(0);
            switch (first) {
                case "":
                    return Optional.of(page.answer(exchange));
                case "parts":
                    return Optional.of(WebResponse.json(parts.toString()));
                case "html":
                    return Optional.of(WebResponse.text("text/html; charset=utf-8", "\u00f1"));
                case "jpeg":
                    return Optional.of(WebResponse.jpeg(PICTURE));
                case "stream":
                    exchange.sendResponseHeaders(WebResponse.OK, -1);
                    exchange.close();
                    return Optional.empty();
                case "busy":
                    throw new IllegalStateException("the program does not answer");
                case "fault":
                    throw new UnsupportedOperationException("on purpose");
                case "interrupted":
                    throw new InterruptedException("on purpose");
                default:
                    throw RequestException.notFound(path, "/ or /parts");
            }
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
        byte[] all = octetsOf(method + " " + path + " HTTP/1.1\r\n" + lines + "Connection: close\r\n\r\n");
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
        get("/parts/a%20b/1+1/%C3%B1/?not=this").expect(200, "[parts, a b, 1+1, \u00f1]");
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
    void aStreamAnswersByItself() throws IOException {
        Answer stream = get("/stream");
        stream.expect(200, "");
        assertNull(stream.headers().get("content-type"));
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
        assertTrue(get("/parts/%4").statusLine().contains(" 400 "));
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

    @ParameterizedTest
    @ValueSource(strings = {"/fault", "/interrupted"})
    void aFaultClosesTheConnectionAndTheNextRequestIsAnswered(String path) throws IOException {
        assertEquals(0, octetsOf("GET " + path + " HTTP/1.1\r\n\r\n").length);
        get("/parts").expect(200, "[parts]");
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
    void aPageIsCompressedForAClientThatAcceptsIt(String encodings) throws IOException {
        Answer answer = get("/", "Accept-Encoding: " + encodings);
        assertEquals("gzip", answer.headers().get("content-encoding"));
        assertEquals("Accept-Encoding", answer.headers().get("vary").replace("Origin, ", ""));
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(answer.body()))) {
            assertEquals(PAGE, new String(in.readAllBytes(), StandardCharsets.UTF_8));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"identity", "gzip;q=0", "gzip; q=0.000, br", "xgzip"})
    void aPageIsPlainForAClientThatDoesNot(String encodings) throws IOException {
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
    void halfARequestIsClosedAndDelaysNoOther() throws IOException {
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
            assertTrue(all.url().matches("http://[0-9.]+:" + all.port() + "/"), all.url());
            assertFalse(all.url().contains("//0.0.0.0"), all.url());
        }
    }
}
