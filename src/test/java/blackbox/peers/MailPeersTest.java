package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.RunningProgram;
import blackbox.Scenario;
import java.net.ServerSocket;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Mail programs that were written elsewhere: aiosmtpd takes the phones' mail, with faults; swaks sends orders. */
@Tag("peer")
class MailPeersTest {
    private static final int MESSAGES = Integer.getInteger("mail.messages", 100);

    private final Scenario scenario = new Scenario("mail");
    private Process server;
    private PrintedLines printed;
    private int serverPort;

    @BeforeEach
    void start() throws Exception {
        Peer.PYTHON.require();
        Peer.require(Peer.PYTHON.run("-c", "import aiosmtpd").status() == 0, "aiosmtpd (Python)");
        try (ServerSocket free = new ServerSocket(0)) {
            serverPort = free.getLocalPort();
        }
        server = Peer.PYTHON
                .process(Peer.source("aiosmtpd_faults.py"), String.valueOf(serverPort))
                .start();
        printed = new PrintedLines(server);
        printed.await("ready");
        scenario.center("--smpp", "0");
    }

    @AfterEach
    void stop() throws Exception {
        if (server != null) {
            server.destroyForcibly();
            server.waitFor();
        }
        scenario.close();
    }

    private Set<String> ids() {
        return printed.of("mail").stream()
                .map(line -> line.split(" ")[1])
                .collect(Collectors.toCollection(TreeSet::new));
    }

    private static String swaks(int port, String to, String body) throws Exception {
        return Peer.SWAKS
                .run("--server", "127.0.0.1:" + port, "--from", "ann@example.org", "--to", to, "--body", body)
                .text();
    }

    @Test
    void anOrderOfSwaksDrivesTheRobotAndAiosmtpdGetsItsAnswer() throws Exception {
        Peer.SWAKS.require();
        RunningProgram robot = scenario.robot("empty.map", "--speed", "20");
        RunningProgram gateway = scenario.mailGateway(serverPort);
        int port = Integer.parseInt(gateway.expect("ready").field("mail"));
        String sent = swaks(port, Scenario.ROBOT + "@sms.example", "** #**20 **");
        assertTrue(sent.contains("<-  250 2.0.0 taken by the network"), sent);
        robot.expect("order", "text", "**#**20**", "verdict", "accepted");
        gateway.expect("mailed", "to", "ann@example.org");
        printed.await("mail");
        assertTrue(printed.of("mail").get(0).endsWith(" ann@example.org auto-replied"));
        assertTrue(
                printed.of("text").get(0).startsWith("text 3 Done: #**20."),
                printed.of("text").get(0));
        assertTrue(swaks(port, "5550200@elsewhere.example", "x").contains("<** 550 5.7.1"));
    }

    @Test
    void aServersFaultsAreErrorsForNowOrForGood() throws Exception {
        RunningProgram phone = scenario.phone(Scenario.PHONE);
        RunningProgram gateway = scenario.mailGateway(serverPort);
        gateway.expect("ready");
        phone.say("sms 6245 silent@example.org Hello");
        for (String name : List.of("later", "full", "closes")) {
            phone.say("sms 6245 " + name + "@example.org Hello");
            gateway.expect("mail-failed", "to", name + "@example.org");
        }
        phone.say("sms 6245 nobody@example.org Hello");
        phone.expect("sms", "from", "6245", "text", "mail to nobody@example.org failed: 550 5.1.1 no such user");
        phone.expect("sms-undelivered", "to", "6245");
        gateway.expect("mail-failed", "to", "silent@example.org", "text", "421 no answer within 20 s");
        assertEquals(List.of(), printed.of("mail"));
    }

    @Test
    void aGatewayThatIsKilledAmongMessagesMailsEachByOneMessageId() throws Exception {
        RunningProgram phone = scenario.phone(Scenario.PHONE);
        RunningProgram gateway = scenario.mailGateway(serverPort);
        gateway.expect("ready");
        int kills = 0;
        for (int i = 0; i < MESSAGES; i++) {
            phone.say("sms 6245 ann@example.org Message " + i);
            if (i % 20 == 10) {
                gateway.kill();
                kills++;
                gateway = scenario.mailGateway(serverPort);
                gateway.expect("ready");
            }
        }
        printed.await(lines -> ids().size() >= MESSAGES, "all messages are mailed");
        Set<String> texts = new TreeSet<>(printed.of("text"));
        System.out.printf(
                "  %d messages, %d kills: %d mails, %d Message-IDs, %d texts%n",
                MESSAGES, kills, printed.of("mail").size(), ids().size(), texts.size());
        assertEquals(MESSAGES, ids().size());
        assertEquals(MESSAGES, texts.size());
    }
}
