package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The gateway of mail over real sockets: an order by mail, its answer, a phone's mail, and the options. */
class MailTest {
    private static final String ANN = "ann@example.org";

    @Test
    void anOrderByMailDrivesTheRobotAndItsAnswerIsMailed() throws Exception {
        try (Scenario scenario = new Scenario("order by mail");
                MailServer server = new MailServer()) {
            scenario.center("--smpp", "0");
            RunningProgram robot = scenario.robot("empty.map", "--speed", "20");
            RunningProgram gateway = scenario.mailGateway(server.port());
            int port = Integer.parseInt(gateway.expect("ready").field("mail"));
            gateway.say("users").expect("user", "kind", "mail", "number", "6245", "state", "idle");
            String to = Scenario.ROBOT + "@sms.example";
            assertTrue(MailServer.send(port, ANN, to, "Subject: Go\n\n** #**20 **\n-- \nAnn")
                    .startsWith("250 "));
            robot.expect("order", "text", "**#**20**", "verdict", "accepted");
            assertTrue(robot.expect("reply").field("to").matches("6245[0-9]{8}"));
            String answer = server.next();
            assertTrue(answer.contains("RCPT TO:<" + ANN + ">\n"), answer);
            assertTrue(answer.contains("Subject: Re: Go\n"), answer);
            assertTrue(answer.contains("Auto-Submitted: auto-replied\n"), answer);
            gateway.expect("mailed", "to", ANN);

            scenario.tell("an order that is not alone in the first line is not executed");
            assertTrue(MailServer.send(port, ANN, to, "\nHello\n** #**20 **").startsWith("250 "));
            robot.expect("order", "verdict", "invalid");
            assertTrue(
                    MailServer.send(port, ANN, "5550200@other.example", "\nx").startsWith("550 "));
            gateway.expect("refused", "kind", "mail", "cause", "550");
            assertEquals(0, gateway.quit());
        }
    }

    @Test
    void twoPeopleWhoOrderOneRobotGetTheirOwnAnswersAndNobodyThoseOfAKilledGateway() throws Exception {
        try (Scenario scenario = new Scenario("two people order by mail");
                MailServer server = new MailServer()) {
            scenario.center("--smpp", "0");
            RunningProgram robot = scenario.robot("empty.map", "--speed", "0", "--operators", "5550100,6245*");
            RunningProgram gateway = scenario.mailGateway(server.port());
            int port = Integer.parseInt(gateway.expect("ready").field("mail"));
            String to = Scenario.ROBOT + "@sms.example";
            MailServer.send(port, ANN, to, "\n** #**20 **");
            robot.expect("order", "verdict", "accepted");
            MailServer.send(port, "bob@x.org", to, "\n** #**30 **");
            assertAnswer(server.next(), "bob@x.org", "6 ");
            MailServer.send(port, "eve@x.org", to, "\nHello");
            assertAnswer(server.next(), "eve@x.org", "7 ");
            robot.say("speed 20");
            assertAnswer(server.next(), ANN, "3 ");

            robot.say("speed 0");
            MailServer.send(port, ANN, to, "\n** #**20 **");
            robot.expect("order", "verdict", "accepted");
            gateway.kill();
            RunningProgram second = scenario.mailGateway(server.port());
            port = Integer.parseInt(second.expect("ready").field("mail"));
            MailServer.send(port, "bob@x.org", to, "\n** #**30 **");
            assertAnswer(server.next(), "bob@x.org", "6 ");
            robot.say("speed 20");
            second.expect("mail-failed", "to", "-", "text", "no address");
        }
    }

    private static void assertAnswer(String mail, String to, String text) {
        assertTrue(mail.contains("RCPT TO:<" + to + ">\n") && mail.contains("\n\n" + text), mail);
    }

    @Test
    void aPhonesMessageIsMailedAndOneThatNoServerTakesStaysInTheNetwork() throws Exception {
        try (Scenario scenario = new Scenario("mail of a phone");
                MailServer server = new MailServer()) {
            scenario.center("--smpp", "0");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            MailServer closed = new MailServer();
            closed.close();
            RunningProgram gateway = scenario.mailGateway(closed.port());
            gateway.expect("ready");
            phone.say("sms 6245 ann@example.org(Lunch)At one?");
            gateway.expect("mail-failed", "to", ANN);
            assertEquals(0, gateway.quit());
            scenario.mailGateway(server.port()).expect("ready");
            String mail = server.next();
            assertTrue(mail.contains("From: <" + Scenario.PHONE + "@sms.example>\n"), mail);
            assertTrue(mail.contains("Subject: Lunch\n") && mail.endsWith("\n\nAt one?\n"), mail);
            phone.expect("sms-delivered");
            scenario.tell("the parts of a long message are one mail");
            phone.say("sms 6245 ann@example.org " + "0123456789".repeat(40) + " []");
            assertTrue(server.next().endsWith("\n\n" + "0123456789".repeat(40) + " []\n"));
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--mail-number 6245|mail needs --smpp, --mail-number and --mail-domain; --smpp is missing",
                "--smpp h:1 --mail-number 6245 --mail-domain d|mail needs --mail-to, --mail-in or both",
                "--smpp h:1 --mail-number x --mail-domain d --mail-in 0|\"x\" is not a telephone number",
                "--smpp h:1 --mail-number 123456789012 --mail-domain d --mail-in 0|expected at most 11 digits",
                "--smpp h:1 --mail-number 1 --mail-domain -d --mail-in 0|expected a domain such as sms.example",
                "--smpp h:1 --smpp-user x --mail-number 1 --mail-domain d --mail-in 0|expected ID:PASSWORD",
            })
    void aMissingOrWrongOptionIsNamed(String options, String text) throws Exception {
        String[] words = ("--headless " + options).split(" ");
        FinishedProgram gateway = FinishedProgram.run("simgsm-gateway", words);
        assertEquals(2, gateway.status());
        assertTrue(gateway.error().contains(text), gateway.error());
    }
}
