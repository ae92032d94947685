package blackbox;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Requests that are none, or are malformed, to the web ports of centre and SimRobot: each answer has one form. */
public class WebErrorsTest {
    private static final Map<String, String> REQUESTS_AND_STATUS = Map.of(
            "GET //robots HTTP/1.1",
            "404 Not Found",
            "GET /%zz HTTP/1.1",
            "400 Bad Request",
            "GET /" + "a".repeat(200_000) + " HTTP/1.1",
            "414 URI Too Long",
            "GET / HTTP/1.1\r\nA: " + "a".repeat(200_000),
            "431 Request Header Fields Too Large",
            "GET / HTTP/1.1\r\nno colon",
            "400 Bad Request",
            "GET robots HTTP/1.1",
            "400 Bad Request",
            "BREW /robots HTTP/1.1",
            "405 Method Not Allowed",
            "hello",
            "400 Bad Request",
            "GET / HTTP/2.0",
            "505 HTTP Version Not Supported");

    private static String answer(int port, String request) throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            socket.getOutputStream()
                    .write((request + "\r\nConnection: close\r\n\r\n").getBytes(StandardCharsets.US_ASCII));
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static void expectErrorsInOneForm(int port) throws IOException {
        for (Map.Entry<String, String> request : REQUESTS_AND_STATUS.entrySet()) {
            String answer = answer(port, request.getKey());
            assertTrue(answer.startsWith("HTTP/1.1 " + request.getValue() + "\r\n"), answer);
            assertTrue(answer.contains("\r\nContent-Type: application/json\r\n"), answer);
            assertTrue(answer.contains("\r\nX-Content-Type-Options: nosniff\r\n"), answer);
            assertTrue(answer.matches("(?s).*\r\n\r\n\\{\"error\":\"[^\"]+\"}"), answer);
            assertTrue(answer.length() < 1000, "a request is not sent back");
        }
    }

    @Test
    void everyErrorIsJsonAtBothPorts() throws Exception {
        try (Scenario scenario = new Scenario("errors on the web")) {
            scenario.center("--http", "0");
            expectErrorsInOneForm(URI.create(scenario.centerUrl()).getPort());
            RunningProgram robot = scenario.robot("empty.map", "--http=0");
            expectErrorsInOneForm(Integer.parseInt(robot.said("ready").field("http")));
        }
    }
}
