package simgsm.web;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpExchange;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.net.SelectorLoop;

@Timeout(20)
class WebSocketPortTest {
    private static final String HANDSHAKE = """
            GET /echo HTTP/1.1
            Host: 127.0.0.1:80
            Upgrade: WebSocket
            Connection: keep-alive, Upgrade
            Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==
            Sec-WebSocket-Version: 13
            """;
    private static final int MOST_OCTETS = 1_000;

    private final SelectorLoop loop = new SelectorLoop("web");
    private final BlockingQueue<String> closed = new LinkedBlockingQueue<>();
    private final List<InetSocketAddress> clients = new ArrayList<>();
    private WebPort port;

    @BeforeEach
    void openPort() throws IOException {
        WebPages pages = new WebPages("default-src 'none'") {
            @Override
            protected Optional<WebResponse> answer(HttpExchange exchange, List<String> parts, String path)
                    throws RequestException {
                clients.add(client(exchange));
                if (parts.isEmpty()) {
                    return Optional.of(WebResponse.text("text/html; charset=utf-8", "page"));
                }
                if (parts.get(0).equals("large")) {
                    return Optional.of(new WebResponse(WebResponse.OK, "image/png", new byte[3_000_000]));
                }
                throw RequestException.notFound(path, "/");
            }
        };
        WebSocketPath echo = new WebSocketPath("/echo", "echo.v1", false, MOST_OCTETS, Echo::new);
        InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        WebSocketPath open = new WebSocketPath("/open", "", true, MOST_OCTETS, socket -> {
            socket.send(socket.isLocalPage() + " " + socket.hasOutput());
            return new Echo(socket);
        });
        port = new WebPort(loop::listen, address, pages, List.of(echo, open), false);
        loop.start(SelectorLoop.Core.NONE, fault -> {});
        port.start();
    }

    @AfterEach
    void closePort() {
        port.close();
        loop.close();
    }

    private final class Echo implements WebSocketListener {
        private final WebSocket socket;

        Echo(WebSocket socket) {
            this.socket = socket;
        }

        @Override
        public void text(String text) {
            socket.send(text);
        }

        @Override
        public void binary(byte[] octets) {
            if (octets.length == 3) {
                socket.close(WebSocket.UNSUPPORTED_DATA, "three octets");
            } else if (octets.length == 1) {
                for (int i = 0; i < octets[0]; i++) {
                    socket.send(new byte[] {(byte) i});
                }
            } else {
                socket.send(octets);
            }
        }

        @Override
        public void closed() {
            closed.add("closed");
        }
    }

    /** A client that sends what it is told, right or wrong. */
    private final class Client implements AutoCloseable {
        private final Socket socket = new Socket(InetAddress.getLoopbackAddress(), port.port());
        private final DataInputStream in = new DataInputStream(socket.getInputStream());

        Client(String request) throws IOException {
            socket.setSoTimeout(15_000);
            send(request.replace("\n", "\r\n").getBytes(StandardCharsets.UTF_8));
        }

        void send(byte[] octets) throws IOException {
            socket.getOutputStream().write(octets);
        }

        String line() throws IOException {
            StringBuilder line = new StringBuilder();
            for (int octet = in.read(); octet >= 0 && octet != '\n'; octet = in.read()) {
                line.append((char) octet);
            }
            return line.toString().strip();
        }

        List<String> head() throws IOException {
            List<String> lines = new ArrayList<>();
            for (String line = line(); !line.isEmpty(); line = line()) {
                lines.add(line);
            }
            return lines;
        }

        /** The next frame of the server in hex, first octet and payload. */
        String frame() throws IOException {
            int first = in.readUnsignedByte();
            int length = in.readUnsignedByte();
            byte[] payload = new byte[length == 126 ? in.readUnsignedShort() : length];
            in.readFully(payload);
            return HexFormat.of().formatHex(new byte[] {(byte) first})
                    + HexFormat.of().formatHex(payload);
        }

        @Override
        public void close() throws IOException {
            socket.close();
        }
    }

    private Client open() throws IOException {
        Client client = new Client(HANDSHAKE + "\n");
        assertEquals("HTTP/1.1 101 Switching Protocols", client.head().get(0));
        return client;
    }

    /** A client's frame: the mask is 0, so the payload is as given. */
    private static byte[] frame(int first, String hex) {
        byte[] payload = HexFormat.of().parseHex(hex);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(first);
        if (payload.length > 125) {
            out.write(0xfe);
            out.write(payload.length >> 8);
            out.write(payload.length);
        } else {
            out.write(0x80 | payload.length);
        }
        out.writeBytes(new byte[4]);
        out.writeBytes(payload);
        return out.toByteArray();
    }

    @Test
    void theExampleOfTheStandardIsAnswered() throws IOException {
        try (Client client = new Client(HANDSHAKE + "Sec-WebSocket-Protocol: other, echo.v1\n\n")) {
            List<String> head = client.head();
            assertTrue(head.contains("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo="), head.toString());
            assertTrue(head.contains("Sec-WebSocket-Protocol: echo.v1"), head.toString());
        }
    }

    @Test
    void aClientThatReadsGetsAllOfTheMessagesSentAtOnce() throws IOException {
        try (Client client = open()) {
            client.send(frame(0x82, "64"));
            for (int i = 0; i < 100; i++) {
                assertEquals(String.format("82%02x", i), client.frame());
            }
        }
    }

    @Test
    void aPingInsideAMessageDoesNotCountTowardsItsLimit() throws IOException {
        try (Client client = open()) {
            client.send(frame(0x01, "61".repeat(MOST_OCTETS)));
            client.send(frame(0x89, "62"));
            assertEquals("8a62", client.frame());
            client.send(frame(0x80, ""));
            assertEquals("81" + "61".repeat(MOST_OCTETS), client.frame());
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "GET /echo|POST /echo|405",
                "GET /echo|GET /other|404",
                "Version: 13|Version: 8|426",
                "dGhlIHNhbXBsZSBub25jZQ==|dGhl|400",
                "keep-alive, Upgrade|keep-alive|400",
                "Host: 127.0.0.1:80|Accept: x|400",
                "Host: 127.0.0.1:80|Host: elsewhere.example|403",
                "Upgrade: W|Origin: http://elsewhere.example;Upgrade: W|403",
                "GET /echo HTTP/1.1|nonsense|400",
                "HTTP/1.1|HTTP/1.0|400",
            })
    void aWrongHandshakeIsRefusedByStatus(String right, String wrong, int status) throws IOException {
        String request = HANDSHAKE.replace(right, wrong.replace(';', '\n'));
        try (Client client = new Client(request + "\n")) {
            assertEquals("HTTP/1.1 " + status + " Refused", client.head().get(0));
        }
    }

    @Test
    void aPageOfTheSameHostIsAdmitted() throws IOException {
        try (Client client = new Client(HANDSHAKE + "Origin: http://127.0.0.1:80\n\n")) {
            assertEquals("HTTP/1.1 101 Switching Protocols", client.head().get(0));
        }
    }

    @ParameterizedTest
    @CsvSource({
        "http://elsewhere.example, false",
        "null, false",
        "http://localhost.elsewhere.example, false",
        "http://localhost:8000, true",
        "http://127.0.0.1, true"
    })
    void aPathForPagesOfEveryHostTellsItsListenerWhichAreLocal(String origin, boolean isLocal) throws IOException {
        String request =
                HANDSHAKE.replace("/echo", "/open") + "Sec-WebSocket-Protocol: any\nOrigin: " + origin + "\n\n";
        try (Client client = new Client(request)) {
            assertEquals("HTTP/1.1 101 Switching Protocols", client.head().get(0));
            String told = isLocal + " true";
            assertEquals("81" + HexFormat.of().formatHex(told.getBytes(StandardCharsets.US_ASCII)), client.frame());
        }
    }

    /** Frames as FIRST_OCTET:PAYLOAD, or octets as they are; the first octets of the answer. */
    @ParameterizedTest
    @CsvSource({
        "817a, an unmasked text, 8803ea",
        "c1:61, a reserved bit, 8803ea",
        "83:61, unknown opcode, 8803ea",
        "8b:61, unknown control opcode, 8803ea",
        "09:61, a ping in fragments, 8803ea",
        "89fe007e00000000, a ping of 126 octets, 8803ea",
        "80:61, a continuation of nothing, 8803ea",
        "01:61 81:61, a text inside a fragmented one, 8803ea",
        "81:ff, a text that is not UTF-8, 8803ef",
        "01:c3 80:28, a text whose fragments are not UTF-8, 8803ef",
        "82ff0000010000000000, 2^40 octets from the head alone, 8803f1",
        "82ff8000000000000000, 2^63 octets, 8803f1",
        "82fe03e9, one octet more than the limit, 8803f1",
        "88:03, a close code of one octet, 8803ea",
        "88:03ed, close code 1005, 8803ea",
        "88:03e8ff, a reason that is not UTF-8, 8803ef",
        "88:, a close without a code, 88",
        "88:03e8, an ordinary close, 8803e8",
        "88:0fa0, a close code of an application, 880fa0",
        "82:010203, a close by the listener, 8803eb",
        "89:0102, a ping, 8a0102",
        "01:61 89:01 80:62, a ping between fragments, 8a01",
    })
    void framesAreAnswered(String sent, String what, String answer) throws Exception {
        try (Client client = open()) {
            for (String each : sent.split(" ")) {
                int colon = each.indexOf(':');
                client.send(
                        colon < 0
                                ? HexFormat.of().parseHex(each)
                                : frame(HexFormat.fromHexDigits(each, 0, colon), each.substring(colon + 1)));
            }
            String frame = client.frame();
            assertTrue(frame.startsWith(answer), what + ": " + frame);
            if (answer.startsWith("88")) {
                assertEquals("closed", closed.poll(10, TimeUnit.SECONDS));
            }
        }
    }

    @Test
    void fragmentsWithAPingBetweenThemAreOneMessage() throws IOException {
        try (Client client = open()) {
            for (byte octet : concat(frame(0x01, "c3"), frame(0x89, "01"), frame(0x80, "b1"))) {
                client.send(new byte[] {octet});
            }
            assertEquals("8a01", client.frame());
            assertEquals("81c3b1", client.frame());
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 125, 126, 1_000})
    void messagesOfEachLengthFormAreEchoed(int octets) throws IOException {
        try (Client client = open()) {
            client.send(frame(0x82, "07".repeat(octets)));
            assertEquals("82" + "07".repeat(octets), client.frame());
        }
    }

    @Test
    void anEndOfTheConnectionIsReported() throws Exception {
        open().close();
        assertEquals("closed", closed.poll(10, TimeUnit.SECONDS));
    }

    @Test
    void otherRequestsArePassedToThePagesAlsoAfterEachOther() throws IOException {
        try (Client client = new Client("GET / HTTP/1.1\nHost: localhost\n\n")) {
            assertEquals("HTTP/1.1 200 OK", client.head().get(0));
            byte[] page = new byte[4];
            client.in.readFully(page);
            assertArrayEquals("page".getBytes(StandardCharsets.UTF_8), page);
            client.send("GET /large HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n"
                    .getBytes(StandardCharsets.UTF_8));
            assertEquals("HTTP/1.1 200 OK", client.head().get(0));
            assertEquals(3_000_000, client.in.readAllBytes().length);
            assertEquals(client.socket.getLocalPort(), clients.get(1).getPort());
        }
    }

    @Test
    void aClientThatEndsItsSideStillGetsTheAnswer() throws IOException {
        try (Client client = new Client("GET /large HTTP/1.0\nHost: localhost\n\n")) {
            client.socket.shutdownOutput();
            assertEquals("HTTP/1.1 200 OK", client.head().get(0));
            assertEquals(3_000_000, client.in.readAllBytes().length);
        }
    }

    @Test
    void silentAndEndlessHeadsDoNotDisturbOthers() throws IOException {
        List<Client> hostile = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            hostile.add(new Client(i % 2 == 0 ? "" : "GET / HTTP/1.1\nX: "));
        }
        hostile.get(0).send(new byte[20_000]);
        try (Client client = open()) {
            client.send(frame(0x81, "61"));
            assertEquals("8161", client.frame());
        }
        assertEquals("HTTP/1.1 431 Refused", hostile.get(0).head().get(0));
        for (Client each : hostile) {
            each.close();
        }
    }

    private static byte[] concat(byte[]... parts) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Arrays.stream(parts).forEach(out::writeBytes);
        return out.toByteArray();
    }
}
