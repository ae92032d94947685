package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The gateway's port of SIP over real sockets, and its options. */
class SipGatewayTest {
    @Test
    void thePortAnswersAndACallerWithoutRegistrationIsToldOnTheConsole() throws Exception {
        try (Scenario scenario = new Scenario("SIP port");
                DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
            scenario.center();
            RunningProgram gateway = scenario.sipGateway(List.of("5550300"));
            ConsoleEvent ready = gateway.expect("ready");
            assertEquals(Set.of("sip"), ready.fields().keySet(), "without --web there are no pages");
            int port = Integer.parseInt(ready.field("sip"));
            assertTrue(answer(socket, port, "OPTIONS").startsWith("SIP/2.0 200 OK\r\n"));
            assertTrue(answer(socket, port, "INVITE").startsWith("SIP/2.0 403 Forbidden"));
            gateway.expect("refused", "kind", "sip", "cause", "403");
            gateway.say("drop 5550300").expect("error", "text", "drop: no user has the number 5550300");
            gateway.say("users").expect("end", "of", "users", "count", "0");
            assertEquals(0, gateway.quit());
        }
    }

    private static String answer(DatagramSocket socket, int port, String method) throws Exception {
        byte[] request = (method + " sip:5550200@127.0.0.1 SIP/2.0\r\nVia: SIP/2.0/UDP 127.0.0.1:"
                        + socket.getLocalPort()
                        + ";branch=z9hG4bK" + method + ";rport\r\nFrom: <sip:5550300@127.0.0.1>;tag=1\r\nTo: "
                        + "<sip:5550200@127.0.0.1>\r\nCall-ID: " + method + "\r\nCSeq: 1 " + method + "\r\n\r\n")
                .getBytes(StandardCharsets.US_ASCII);
        socket.setSoTimeout(60_000);
        socket.send(new DatagramPacket(request, request.length, InetAddress.getLoopbackAddress(), port));
        DatagramPacket packet = new DatagramPacket(new byte[2_000], 2_000);
        socket.receive(packet);
        return new String(packet.getData(), 0, packet.getLength(), StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "|sip-users.properties",
                "ann=secret|expected lines number=password: \"ann\" is not a telephone number of 1 to 15 digits",
                "5550300=|expected lines number=password: expected a password after 5550300=",
            })
    void aMissingOrWrongListOfUsersIsNamed(String line, String text, @TempDir Path folder) throws Exception {
        if (line != null) {
            Files.writeString(folder.resolve("sip-users.properties"), line);
        }
        FinishedProgram gateway =
                FinishedProgram.run("simgsm-gateway", "--headless", "--sip", "0", "--data", folder.toString());
        assertEquals(74, gateway.status());
        assertTrue(gateway.error().contains(text), gateway.error());
    }
}
