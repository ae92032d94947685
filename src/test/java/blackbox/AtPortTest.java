package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** The ports of {@code --at} on the phone and on SimRobot. */
class AtPortTest {
    @Test
    void aTextMessageOverThePhonesPortMovesTheRobotAndTheRobotsModemAnswersOnItsOwn() throws Exception {
        try (Scenario scenario = new Scenario("AT commands over TCP")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--speed", "20", "--at", "0");
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--at", "0");
            try (Socket phonePort = connect(phone);
                    Socket robotPort = connect(robot)) {
                send(robotPort, "ATE0\rAT+CGMM\r");
                assertEquals("ATE0\r\r\nOK\r\n\r\nM2\r\n\r\nOK\r\n", read(robotPort, 23));
                send(phonePort, "ATE0\rAT+CMGF=1\rAT+CMGS=\"" + Scenario.ROBOT + "\"\r** #**20 **\u001a");
                assertEquals("ATE0\r\r\nOK\r\n\r\nOK\r\n\r\n> ", read(phonePort, 21));
                robot.expect("outcome", "tone", "3");
                phone.expect("sms", "from", Scenario.ROBOT);
                send(robotPort, "AT+CPMS?\r");
                assertEquals("\r\n+CPMS: \"SM\",1,50,", read(robotPort, 19));
            }
        }
    }

    @Test
    void aClientThatSendsNothingMoreStillReadsTheResultOfItsLastCommand() throws Exception {
        try (Scenario scenario = new Scenario("an AT client that ends its output")) {
            scenario.center();
            scenario.robot("empty.map");
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--at", "0");
            try (Socket port = connect(phone)) {
                send(port, "ATE0\rAT+CMGF=1\rAT+CMGS=\"" + Scenario.ROBOT + "\"\r** #*0 **\u001a");
                port.shutdownOutput();
                String all = new String(port.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
                assertTrue(all.matches("(?s).*\\r\\n\\+CMGS: [0-9]+\\r\\n\\r\\nOK\\r\\n"), all);
            }
        }
    }

    @Test
    void aUssdDialogueBelongsToTheClientThatHasBegunItAndNotToTheRobot() throws Exception {
        try (Scenario scenario = new Scenario("USSD at M2's AT port")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--at", "0");
            try (Socket port = connect(robot)) {
                send(port, "ATE0\rAT+CUSD=1,\"*111#\",15\r");
                String menu = "\r\n+CUSD: 1,\"1 Own number\n2 Status of a robot\n0 End\",15\r\n";
                assertEquals("ATE0\r\r\nOK\r\n\r\nOK\r\n" + menu, read(port, 17 + menu.length()));
                send(port, "AT+CUSD=1,\"1\",15\r");
                String answer = "\r\nOK\r\n\r\n+CUSD: 0,\"Your number is " + Scenario.ROBOT + ".\",15\r\n";
                assertEquals(answer, read(port, answer.length()));
            }
        }
    }

    private static Socket connect(RunningProgram program) throws IOException {
        int port = Integer.parseInt(program.said("ready").field("at"));
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout((int) TimeUnit.SECONDS.toMillis(RunningProgram.PATIENCE_SECONDS));
        return socket;
    }

    private static void send(Socket socket, String octets) throws IOException {
        socket.getOutputStream().write(octets.getBytes(StandardCharsets.ISO_8859_1));
    }

    private static String read(Socket socket, int count) throws IOException {
        InputStream input = socket.getInputStream();
        return new String(input.readNBytes(count), StandardCharsets.ISO_8859_1);
    }
}
