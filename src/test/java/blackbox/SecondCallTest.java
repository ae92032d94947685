package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** Two calls at one phone: held, swapped, forwarded, by the console and by AT commands. */
public class SecondCallTest {
    private static final String SECOND = "5550101";
    private static final String THIRD = "5550102";

    @Test
    void twoCallsAreHeldAndSwappedByTheConsoleAndByAtCommands() throws Exception {
        try (Scenario scenario = new Scenario("a call on hold")) {
            scenario.center("--call-waiting", "on");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            RunningProgram second = scenario.phone(SECOND, "--at", "0");
            RunningProgram third = scenario.phone(THIRD);
            phone.say("dial " + SECOND);
            second.expect("ringing", "from", Scenario.PHONE);
            second.say("answer");
            phone.expect("connected");
            third.say("dial " + SECOND);
            second.expect("waiting", "from", THIRD);
            second.say("hold");
            second.expect("held", "number", Scenario.PHONE);
            second.expect("connected", "number", THIRD);
            third.expectBefore(Set.of("released"), "connected");
            scenario.tell("the keys of the third reach the phone that holds the first");
            third.say("press 7");
            second.expect("tone", "key", "7");
            try (Socket port = connect(second)) {
                send(port, "ATE0\rAT+CHLD=?\r");
                expect(port, "ATE0\r\r\nOK\r\n\r\n+CHLD: (0,1,2)\r\n\r\nOK\r\n");
                send(port, "AT+CHLD=2\r");
                second.expect("retrieved", "number", Scenario.PHONE);
                expect(port, "\r\nOK\r\n");
                send(port, "AT+CLCC\r");
                String list = "\r\n+CLCC: 1,1,0,0,0,\"" + Scenario.PHONE + "\",129\r\n\r\n+CLCC: 2,1,1,0,0,\"" + THIRD
                        + "\",129\r\n\r\nOK\r\n";
                expect(port, list);
                phone.say("press 5");
                second.expect("tone", "key", "5");
                send(port, "AT+CHLD=1\r");
                phone.expect("released", "cause", "16");
                second.expect("retrieved", "number", THIRD);
            }
            second.say("hangup");
            third.expect("released", "cause", "16");
        }
    }

    /** The second phone talks with the first, takes the third, and swaps them. */
    public static void swap(RunningProgram first, RunningProgram second, RunningProgram third) {
        first.say("dial " + SECOND);
        second.expect("ringing");
        second.say("answer");
        first.expect("connected");
        third.say("dial " + SECOND);
        second.expect("waiting");
        second.say("hold");
        second.expect("held");
        second.expect("connected");
        second.say("hold");
        second.expect("held", "number", THIRD);
        second.expect("retrieved");
        second.say("reject");
        second.expect("held-over");
        third.expect("released", "cause", "16");
        second.say("hangup");
        first.expect("released", "cause", "16");
    }

    @Test
    void aCallIsForwardedWhenTheSubscriberIsDetached() throws Exception {
        try (Scenario scenario = new Scenario("a forwarded call")) {
            scenario.center();
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            RunningProgram second = scenario.phone(SECOND);
            RunningProgram third = scenario.phone(THIRD);
            second.say("ussd **62*" + THIRD + "#").expect("service", "code", "62", "state", "active", "to", THIRD);
            second.say("power off").expect("unregistered");
            phone.say("dial " + SECOND);
            third.expect("ringing", "from", Scenario.PHONE);
            third.say("answer");
            phone.expect("connected");
            phone.say("press 5");
            third.expect("tone", "key", "5");
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

    private static void expect(Socket socket, String answer) throws IOException {
        byte[] octets = socket.getInputStream().readNBytes(answer.length());
        assertEquals(answer, new String(octets, StandardCharsets.ISO_8859_1));
    }
}
