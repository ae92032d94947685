package simgsm.gateway.mail;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.smpp.SmppPdu;

/** Mail that becomes short messages, and the loops that it must not make. */
class MailInTest {
    private static final String ANN = "ann@example.org";
    private static final String ROBOT = "5550200";
    private static final String ORDER = "** #**20 **";
    static final String BOUNCE = """
            Content-Type: multipart/report; boundary="b"

            --b

            It failed.
            ** #**20 **
            --b
            Content-Type: message/delivery-status

            Reporting-MTA: dns; mx

            Final-Recipient: rfc822; ann@example.org
            Status: 5.3.0
            --b
            Content-Type: message/rfc822

            %sSubject: SMS from 5550100

            ** #**20 **
            --b--""";

    private final MailStage stage = new MailStage();

    /** Content; \n is a line end. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Subject: S\\n\\n** #**20 **|** #**20 **",
                "\\n\\n> ** #**90 **\\n** #**20 **\\nOn Monday Bob wrote:\\n> x|** #**20 **",
                "\\n\\n** #**20 **\\n-- \\nAnn|** #**20 **",
                "\\n\\nHello\\nOn Monday Bob wrote:\\n** #**20 **|ann@example.org Hello",
                "\\n\\n..dot|ann@example.org .dot",
                "Content-Transfer-Encoding: base64\\n\\nKiogIyoqMjAgKio=|** #**20 **",
                "Content-Transfer-Encoding: quoted-printable\\nContent-Type: text/plain; charset=iso-8859-1\\n\\nW=F6=\\nrld|ann@example.org Wörld",
                "Content-Type: text/plain; charset=utf-16be\\nContent-Transfer-Encoding: base64\\n\\nAEgAaQ==|ann@example.org Hi",
                "Content-Type: text/plain; charset=unknown\\n\\nHi|ann@example.org Hi",
                "Content-Type: multipart/alternative; boundary=b\\n\\nx\\n--b\\nContent-Type: text/html\\n\\n<p>no</p>\\n--b\\n\\n** #**20 **\\n--b--|** #**20 **",
                "Content-Type: text/html\\n\\n<style>p{}</style><p>a &lt; b</p>|ann@example.org a < b",
                "Content-Type: image/png\\n\\nxyz|ann@example.org (no text)",
                "Content-Type:\\n text/plain;\\n  charset=iso-8859-1\\nContent-Transfer-Encoding: quoted-printable\\n \\n=F6|ann@example.org ö",
                "Subject: without a body|'ann@example.org '",
            })
    void theOwnWordsOfAMailAreTheMessageAndAnOrderStandsAlone(String content, String text) {
        stage.mail(ANN, ROBOT, content.replace("\\n", "\n"));
        SmppPdu.Message submitted = stage.submitted();
        assertEquals(text, MailStage.text(submitted));
        assertEquals(ROBOT, submitted.message().destination().value());
        assertTrue(submitted.message().source().value().matches("6245[0-9]{8}"), "a number of its own");
        assertEquals(0x32, submitted.message().protocolId());
    }

    @Test
    void aLongTextEndsAfterAThousandCharacters() {
        stage.mail(ANN, ROBOT, "\n" + "é".repeat(998 / 2) + "\n" + "ж".repeat(499) + "\n" + "x".repeat(499));
        assertEquals(ANN.length() + 1 + 1_000, MailStage.text(stage.submitted()).length());
    }

    @ParameterizedTest
    @CsvSource({"0, 250", "0x0b, 550", "0x58, 451", "0x14, 451", "0x08, 451", "0x45, 554"})
    void theMailIsAnsweredAfterTheSmscByItsStatus(String status, String reply) {
        MailStage.Wire client = stage.mail(ANN, ROBOT, "\n" + ORDER);
        assertEquals("", client.text());
        stage.answer(stage.submitted(), Integer.decode(status));
        assertTrue(client.text().startsWith(reply + " "));
    }

    @Test
    void aMailWithoutTheSmscIsRefusedForNow() {
        MailStage.Wire client = stage.mail(ANN, ROBOT, "\n" + ORDER);
        stage.smsc.protocol.lost("gone");
        assertTrue(client.text().startsWith("451 "));
        assertTrue(stage.mail(ANN, ROBOT, "\n" + ORDER).text().startsWith("451 "));
    }

    /** Sender, header, reply: nothing is submitted. */
    @ParameterizedTest
    @CsvSource({
        "ann@example.org, Auto-Submitted: auto-replied, 550",
        "ann@example.org, Auto-Submitted: auto-generated; x, 550",
        "ann@example.org, Precedence: bulk, 550",
        "ann@example.org, Precedence: junk, 550",
        "ann@example.org, Precedence: List, 550",
        "ann@example.org, List-Id: <l.example>, 550",
        "MAILER-DAEMON@example.org, X: y, 550",
        "'', X: y, 250",
        "ann@example.org, From: Mail <MAILER-DAEMON@example.org>, 550",
    })
    void automaticMailIsNeverAnOrder(String sender, String header, String reply) {
        MailStage.Wire client = stage.mail(sender, ROBOT, header + "\n\n" + ORDER);
        assertTrue(client.text().startsWith(reply + " "));
        assertEquals(List.of(), stage.pdus());
    }

    @Test
    void mailThatSaysItIsNotAutomaticIsAnOrder() {
        stage.mail(ANN, ROBOT, "Auto-Submitted: no\n\n" + ORDER);
        assertEquals(ORDER, MailStage.text(stage.submitted()));
    }

    @Test
    void theBounceOfARobotsOwnOrderIsToldWithoutTheOrder() {
        MailStage.Wire client = stage.mail("", ROBOT, BOUNCE.formatted(""));
        SmppPdu.Message notice = stage.submitted();
        assertEquals("mail to ann@example.org failed: 5.3.0", MailStage.text(notice));
        stage.answer(notice, 0);
        assertTrue(client.text().startsWith("250 "));
    }

    @Test
    void aBounceWaitsForTheSmsc() {
        stage.smsc.protocol.lost("gone");
        assertTrue(stage.mail("", ROBOT, BOUNCE.formatted("")).text().startsWith("451 "));
    }

    @Test
    void theBounceOfAnAutomaticAnswerEndsTheLoop() {
        MailStage.Wire client = stage.mail("", ROBOT, BOUNCE.formatted("Auto-Submitted: auto-replied\n"));
        assertTrue(client.text().startsWith("250 "));
        assertEquals(List.of(), stage.pdus());
    }

    @Test
    void anEleventhMailWithinAnHourFromOneAddressToOneNumberIsRefused() {
        for (int i = 0; i < 10; i++) {
            stage.mail(ANN, ROBOT, "\n" + ORDER);
            stage.answer(stage.submitted(), 0);
        }
        assertTrue(stage.mail(ANN, ROBOT, "\n" + ORDER).text().startsWith("550 "));
        stage.mail("bob@example.org", ROBOT, "\n" + ORDER);
        stage.answer(stage.submitted(), 0);
        stage.pass(3_600);
        stage.pdus();
        stage.mail(ANN, ROBOT, "\n" + ORDER);
        stage.submitted();
    }

    @Test
    void theRobotsAnswerIsMailedToTheOneWhoOrderedAndMarkedAutomatic() {
        SmppPdu.Message order =
                stage.mailed(ANN, ROBOT, "Message-ID: <1@x>\nSubject: =?utf-8?Q?T=C3=A9st_1?=\n\n" + ORDER, 0);
        stage.reply(order, 1, "Done.");
        String answer = stage.takeMail();
        assertTrue(answer.contains("RCPT TO:<ann@example.org>"), answer);
        assertTrue(answer.contains("Subject: =?utf-8?B?UmU6IFTDqXN0IDE=?=\r\n"), answer);
        assertTrue(
                answer.contains("In-Reply-To: <1@x>\r\nReferences: <1@x>\r\nAuto-Submitted: auto-replied\r\n"), answer);
    }

    @Test
    void twoPeoplesOrdersAreAnsweredToEachInWhateverOrderTheRobotAnswers() {
        SmppPdu.Message anns = stage.mailed(ANN, ROBOT, "Message-ID: <1@x>\n\n" + ORDER, 0);
        SmppPdu.Message bobs = stage.mailed("bob@x.org", ROBOT, "Message-ID: <2@x>\n\n" + ORDER, 0);
        stage.reply(bobs, 1, "6 Executing a command.");
        stage.reply(anns, 2, "3 Done.");
        String first = stage.takeMail();
        assertTrue(first.contains("RCPT TO:<bob@x.org>") && first.contains("In-Reply-To: <2@x>"), first);
        assertTrue(first.endsWith("\r\n\r\n6 Executing a command.\r\n.\r\n"), first);
        String second = stage.takeMail();
        assertTrue(second.contains("RCPT TO:<ann@example.org>") && second.contains("In-Reply-To: <1@x>"), second);
    }

    @Test
    void anOrderThatTheSmscRefusesTakesNoAnswerOfAnother() {
        stage.mailed(ANN, ROBOT, "\n" + ORDER, 0x45);
        SmppPdu.Message bobs = stage.mailed("bob@x.org", ROBOT, "\n" + ORDER, 0);
        stage.reply(bobs, 1, "3 Done.");
        assertTrue(stage.takeMail().contains("RCPT TO:<bob@x.org>"));
    }

    @Test
    void aTextThatIsNoOrderIsAnsweredToTheOneWhoWroteIt() {
        SmppPdu.Message anns = stage.mailed(ANN, ROBOT, "\n" + ORDER, 0);
        SmppPdu.Message bobs = stage.mailed("bob@x.org", ROBOT, "\nHello", 0);
        stage.reply(bobs, 1, "7 Not a valid command.");
        stage.reply(anns, 2, "3 Done.");
        String first = stage.takeMail();
        assertTrue(first.contains("RCPT TO:<bob@x.org>") && first.contains("auto-replied"), first);
        assertTrue(stage.takeMail().contains("RCPT TO:<ann@example.org>"));
    }

    @Test
    void anAnswerAfterKillMinusNineGoesToNobodyAlsoWhenAnotherHasOrderedSince() {
        SmppPdu.Message anns = stage.mailed(ANN, ROBOT, "\n" + ORDER, 0);
        stage.pass(1);
        stage.restart();
        SmppPdu.Message bobs = stage.mailed("bob@x.org", ROBOT, "\n" + ORDER, 0);
        stage.reply(anns, 1, "3 Done.");
        assertEquals(List.of(0x65), stage.answers());
        assertEquals(List.of(), stage.connecting);
        stage.reply(bobs, 2, "3 Done.");
        assertTrue(stage.takeMail().contains("RCPT TO:<bob@x.org>"));
    }

    @Test
    void anotherNumbersTextToTheNumberOfAMailIsNoAnswer() {
        SmppPdu.Message anns = stage.mailed(ANN, ROBOT, "\n" + ORDER, 0);
        stage.deliver("5550199", anns.message().source().value(), 1, "3 Done.");
        assertEquals(List.of(0x65), stage.answers());
        stage.deliver("34" + ROBOT, anns.message().source().value(), 2, "3 Done.");
        assertEquals(1, stage.connecting.size(), "a network in a country shows the robot in international form");
    }

    @Test
    void twoRepliersWithoutMarksEndAfterTenMails() {
        int mails = 0;
        stage.deliver("5550100", 1, "ann@example.org Away");
        while (!stage.connecting.isEmpty()) {
            stage.takeMail();
            mails++;
            stage.pdus();
            MailStage.Wire answer = stage.mail(ANN, "5550100", "\nAway, too");
            List<SmppPdu> submitted = stage.pdus();
            if (!submitted.isEmpty()) {
                stage.answer((SmppPdu.Message) submitted.get(0), 0);
                stage.deliver("5550100", 1 + mails, "ann@example.org Away");
            } else {
                assertTrue(answer.text().startsWith("550 "));
            }
        }
        assertEquals(11, mails);
    }

    @Test
    void aMailThatIsSentAgainAfterALostReplyIsSubmittedOnce() {
        stage.mail(ANN, ROBOT, "Message-ID: <1@x>\n\n" + ORDER);
        stage.answer(stage.submitted(), 0);
        MailStage.Wire again = stage.mail(ANN, ROBOT, "Message-ID: <1@x>\n\n" + ORDER);
        assertTrue(again.text().startsWith("250 "));
        assertEquals(List.of(), stage.pdus());
    }

    @Test
    void aMessageIdCannotAddHeadersToTheAnswer() {
        stage.reply(stage.mailed(ANN, ROBOT, "Message-ID: <1@x>\rBcc: <eve@x.org>\n\n" + ORDER, 0), 1, "Done.");
        String answer = stage.takeMail();
        assertTrue(!answer.contains("Bcc") && !answer.contains("In-Reply-To"), answer);
    }

    @Test
    void htmlThatIsAllTagsIsReadInBoundedTime() {
        stage.mail(ANN, ROBOT, "Content-Type: text/html\n\n" + ("<style ".repeat(100) + "\n").repeat(80));
        assertTrue(MailStage.text(stage.submitted()).startsWith(ANN));
    }

    /** Commands parted by /, and the last reply. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "MAIL FROM:<a@b>|503",
                "EHLO x/RCPT TO:<5550200@sms.example>|503",
                "EHLO x/MAIL FROM:<a@b>/DATA|503",
                "EHLO x/MAIL FROM:a@b|501",
                "EHLO x/MAIL FROM:<a\u0001b@c>|501",
                "EHLO x/MAIL FROM:<a\rRCPT@c>|501",
                "EHLO x/MAIL FROM:<ben\u00e9@example.org>|553",
                "EHLO x/MAIL FROM:<> SIZE=100|250",
                "EHLO x/MAIL FROM:<a@b> SIZE=65537|552",
                "EHLO x/MAIL FROM:<a@b>/RCPT TO:<+5550200@SMS.example> NOTIFY=NEVER|250",
                "EHLO x/MAIL FROM:<a@b>/RCPT TO:<@r.example:5550200@sms.example>|250",
                "EHLO x/MAIL FROM:<a@b>/RCPT TO:<5550200@other.example>|550",
                "EHLO x/MAIL FROM:<a@b>/RCPT TO:<ann@sms.example>|550",
                "EHLO x/MAIL FROM:<a@b>/RCPT TO:<1@sms.example>/RCPT TO:<2@sms.example>|452",
                "EHLO x/MAIL FROM:<a@b>/RSET/RCPT TO:<1@sms.example>|503",
                "HELO x/mail from:<a@b>/rcpt to:<1@sms.example>/data|354",
                "EHLO|501",
                "VRFY x|252",
                "NOOP|250",
                "STARTTLS|502",
                "WHAT|500",
                "QUIT|221",
            })
    void aCommandIsAnsweredByItsPlace(String commands, String reply) {
        MailStage.Wire client = new MailStage.Wire(stage.gateway.accepted("192.0.2.1"));
        assertTrue(client.text().startsWith("220 sms.example "));
        String last = "";
        for (String command : commands.split("/")) {
            last = client.say(command);
        }
        assertTrue(last.startsWith(reply), last);
    }

    @Test
    void limitsAreToldAndEndTheConnection() {
        MailStage.Wire big = stage.mail(ANN, ROBOT, "\n" + ("x".repeat(900) + "\n").repeat(80));
        assertTrue(big.text().startsWith("552 "));
        MailStage.Wire client = new MailStage.Wire(stage.gateway.accepted("192.0.2.1"));
        client.say("x".repeat(600));
        assertTrue(client.say("x".repeat(70_000)).startsWith("500 "));
        assertTrue(client.isClosed);
        MailStage.Wire wrong = new MailStage.Wire(stage.gateway.accepted("192.0.2.1"));
        for (int i = 0; i < 20; i++) {
            wrong.say("WHAT");
        }
        assertTrue(wrong.say("WHAT").startsWith("421 "));
        MailStage.Wire silent = new MailStage.Wire(stage.gateway.accepted("192.0.2.1"));
        silent.text();
        stage.pass(300);
        assertTrue(silent.text().startsWith("421 "));
        assertTrue(silent.isClosed);
    }
}
