package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import simgsm.dtmf.DtmfReceiver;

/** A class at one gateway: each browser orders its own robot at the same time, while 200 connections are silent or hostile. */
class ManyBrowsersTest {
    private static final int HOSTILE = 200;
    private static final String ORDER = "**#**20**";
    private static final long FIRST_ROBOT = Long.parseLong(Scenario.ROBOT);

    private static final String HANDSHAKE = """
            GET /phone HTTP/1.1\r
            Host: 127.0.0.1\r
            Upgrade: websocket\r
            Connection: Upgrade\r
            Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r
            Sec-WebSocket-Version: 13\r
            \r
            """;
    /** What a connection sends at once, and what it goes on with, an octet every 100 ms. */
    private static final List<Map.Entry<String, String>> MANNERS = List.of(
            Map.entry("", ""),
            Map.entry("GET / HTTP/1.1\r\nX: ", "a"),
            Map.entry(HANDSHAKE.strip(), ""),
            Map.entry(HANDSHAKE, ""),
            Map.entry(HANDSHAKE + frames("81fe400000000000"), "a"),
            Map.entry(HANDSHAKE + frames("817a"), ""),
            Map.entry(HANDSHAKE + frames("898100000000" + "61").repeat(1_000), ""),
            Map.entry(HANDSHAKE + frames("818200000000" + "6869"), ""));

    private static String frames(String hex) {
        return new String(HexFormat.of().parseHex(hex), StandardCharsets.ISO_8859_1);
    }

    @Test
    void tenBrowsersOrderTheirRobotsBesideHostileConnections() throws Exception {
        order(10);
    }

    @Test
    @Tag("peer")
    void thirtyBrowsersOrderTheirRobotsBesideHostileConnections() throws Exception {
        order(30);
    }

    private static void order(int browsers) throws Exception {
        ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor();
        List<WebPhone> phones = new ArrayList<>();
        List<Socket> hostile = new ArrayList<>();
        try (Scenario scenario = new Scenario(browsers + " browsers")) {
            scenario.center();
            RunningProgram robots = scenario.robot(
                    "office.map",
                    IntStream.range(0, browsers)
                            .boxed()
                            .flatMap(i -> Stream.of("--robot", "robot" + i + "=" + (FIRST_ROBOT + i)))
                            .toArray(String[]::new));
            for (int i = 1; i < browsers; i++) {
                robots.expect("registered");
            }
            String port = scenario.gateway().expect("ready").field("web");
            for (int i = 0; i < HOSTILE; i++) {
                hostile.add(hostile(Integer.parseInt(port), MANNERS.get(i % MANNERS.size()), clock));
            }
            for (int i = 0; i < browsers; i++) {
                phones.add(new WebPhone(port, "{\"key\":\"word\"}"));
                phones.get(i).expect("registered");
            }
            for (int i = 0; i < browsers; i++) {
                phones.get(i).say("{\"do\":\"dial\",\"number\":\"" + (FIRST_ROBOT + i) + "\"}");
            }
            phones.forEach(phone -> phone.expect("connected"));
            phones.forEach(WebPhone::speak);
            phones.forEach(phone -> phone.expect("tone", "key", "1"));
            phones.forEach(phone -> phone.press(ORDER));
            try {
                phones.forEach(phone -> phone.expect("tone", "key", "3"));
            } catch (AssertionError e) {
                throw new AssertionError(robots.toString(), e);
            }
            phones.forEach(phone -> phone.say("{\"do\":\"hangup\"}"));

            List<ConsoleEvent> said = new ArrayList<>();
            for (int i = 0; i < browsers; i++) {
                said.addAll(robots.expectAll("released"));
            }
            Map<String, String> keys = said.stream()
                    .filter(event -> event.name().equals("keys"))
                    .collect(Collectors.groupingBy(
                            event -> event.field("robot"),
                            Collectors.mapping(event -> event.field("keys"), Collectors.joining())));
            assertEquals(
                    IntStream.range(0, browsers).boxed().collect(Collectors.toMap(i -> "robot" + i, i -> ORDER)), keys);
            assertEquals(
                    Collections.nCopies(browsers, "163"),
                    phones.stream().map(ManyBrowsersTest::keysHeard).toList());
            for (Socket each : hostile) {
                awaitEnd(each);
            }
        } finally {
            clock.shutdownNow().clear();
            phones.forEach(WebPhone::close);
            for (Socket each : hostile) {
                each.close();
            }
        }
    }

    private static String keysHeard(WebPhone phone) {
        StringBuilder keys = new StringBuilder();
        new DtmfReceiver(digit -> keys.append(digit.key().symbol())).accept(phone.heard());
        return keys.toString();
    }

    private static Socket hostile(int port, Map.Entry<String, String> manner, ScheduledExecutorService clock)
            throws IOException {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.getOutputStream().write(manner.getKey().getBytes(StandardCharsets.ISO_8859_1));
        byte[] more = manner.getValue().getBytes(StandardCharsets.ISO_8859_1);
        if (more.length > 0) {
            // A write to an ended connection throws, and with it the repetition ends.
            clock.scheduleAtFixedRate(() -> write(socket, more), 100, 100, TimeUnit.MILLISECONDS);
        }
        return socket;
    }

    private static void write(Socket socket, byte[] octets) {
        try {
            socket.getOutputStream().write(octets);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Fails by a timeout if the gateway does not end the connection. */
    private static void awaitEnd(Socket socket) throws IOException {
        socket.setSoTimeout((int) TimeUnit.SECONDS.toMillis(RunningProgram.PATIENCE_SECONDS));
        try {
            socket.getInputStream().readAllBytes();
        } catch (SocketException e) {
            // Reset, since not all had been read.
        }
    }
}
