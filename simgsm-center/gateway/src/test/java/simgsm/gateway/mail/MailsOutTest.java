package simgsm.gateway.mail;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;

/** Short messages that become mail. */
class MailsOutTest {
    private static final String PHONE = "5550100";

    private final MailStage stage = new MailStage();

    @Test
    void theMessageIsAnsweredAfterTheServersReplyToTheText() {
        stage.deliver(PHONE, 7, "ann@example.org Hello\n.dot");
        MailStage.Wire server = stage.serverUntil("TEXT");
        assertEquals(List.of(), stage.answers());
        String dialogue = server.text();
        assertTrue(
                dialogue.startsWith("EHLO sms.example\r\nMAIL FROM:<5550100@sms.example>\r\n"
                        + "RCPT TO:<ann@example.org>\r\nDATA\r\nDate: Thu, 1 Jan 1970 00:00:00 +0000\r\n"),
                dialogue);
        assertTrue(dialogue.contains("\r\nSubject: SMS from 5550100\r\n"), dialogue);
        assertTrue(dialogue.endsWith("\r\n\r\nHello\r\n..dot\r\n.\r\n"), dialogue);
        assertEquals("QUIT\r\n", server.say("250 taken"));
        assertTrue(server.isClosed);
        assertEquals(List.of(0), stage.answers());
        assertEquals(List.of("bound 0", "mailed ann@example.org"), stage.told);
    }

    /** Step, reply or what happens, seconds until then, status of deliver_sm_resp. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "GREETING|421 4.3.0 busy|0|0x64",
                "GREETING|554 no|0|0x65",
                "GREETING|nonsense|0|0x64",
                "GREETING|silence|20|0x64",
                "MAIL|silence|20|0x64",
                "RCPT|451 4.3.0 try later|0|0x64",
                "RCPT|550 5.1.1 no such user|0|0x65",
                "RCPT|close|0|0x64",
                "DATA|452 4.3.1 full|0|0x64",
                "TEXT|452 4.3.1 full|0|0x64",
                "TEXT|554 5.6.0 no|0|0x65",
                "TEXT|close|0|0x64",
                "TEXT|silence|600|0x64",
            })
    void aServerThatDoesNotTakeTheMailIsAnErrorForNowOrForGood(String step, String does, long seconds, String status) {
        stage.deliver(PHONE, 7, "ann@example.org Hello");
        MailStage.Wire server = stage.serverUntil(step);
        if (does.equals("silence")) {
            stage.pass(seconds - 1);
            assertEquals(List.of(), stage.answers());
            stage.pass(1);
        } else if (does.equals("close")) {
            server.protocol.lost("closed by the peer");
        } else {
            server.say(does);
        }
        if (status.equals("0x65")) {
            SmppPdu.Message notice = stage.submitted();
            assertEquals(PHONE, notice.message().destination().value());
            assertEquals("mail to ann@example.org failed: " + does, MailStage.text(notice));
            stage.answer(notice, 0);
        }
        assertEquals(List.of(Integer.decode(status)), stage.answers());
        assertTrue(stage.told.get(1).startsWith("failed ann@example.org "), stage.told.toString());
    }

    @Test
    void withoutAServerTheMessageIsRefusedForNow() {
        stage.deliver(PHONE, 7, "ann@example.org Hello");
        stage.connecting.remove(0).lost("connection refused");
        assertEquals(List.of(0x64), stage.answers());
    }

    @Test
    void aMessageThatIsRepeatedWhileItsMailIsUnderWayIsMailedOnce() {
        stage.deliver(PHONE, 7, "ann@example.org Hello");
        MailStage.Wire server = stage.serverUntil("TEXT");
        stage.pass(31);
        stage.deliver(PHONE, 7, "ann@example.org Hello");
        server.say("250 taken");
        assertEquals(List.of(0), stage.answers());
        stage.deliver(PHONE, 7, "ann@example.org Hello");
        assertEquals(List.of(0), stage.answers());
        assertEquals(List.of(), stage.connecting);
        stage.deliver(PHONE, 8, "ann@example.org Hello");
        assertEquals(1, stage.connecting.size());
    }

    @Test
    void aGatewayThatDiesAmongAHundredMessagesMailsEachByOneMessageId() {
        TreeSet<String> ids = new TreeSet<>();
        TreeSet<Integer> waiting = new TreeSet<>();
        for (int i = 0; i < 100; i++) {
            waiting.add(i);
        }
        for (int life = 0; !waiting.isEmpty(); life++) {
            waiting.forEach(i -> stage.deliver(PHONE, i, "ann@example.org Message " + i));
            int mails = Math.min(10, waiting.size());
            for (int i = 0; i < mails; i++) {
                Matcher id = Pattern.compile("Message-ID: <(.*?)@").matcher(stage.takeMail());
                assertTrue(id.find());
                ids.add(id.group(1));
            }
            // The answer to the last mail of each life is lost.
            List<Integer> answers = stage.answers();
            assertEquals(mails, answers.size());
            for (int i = 0; i < (life % 2 == 0 ? mails : Math.max(1, mails - 1)); i++) {
                waiting.pollFirst();
            }
            stage.restart();
        }
        assertEquals(100, ids.size());
    }

    @Test
    void thePartsOfALongMessageAreOneMail() {
        byte[][] parts = {
            "\5\0\3\1\2\1ann@example.org The first ".getBytes(StandardCharsets.ISO_8859_1),
            "\5\0\3\1\2\2and the second".getBytes(StandardCharsets.ISO_8859_1)
        };
        stage.deliver(PHONE, 8, SmppMessage.HAS_HEADER, parts[1]);
        assertEquals(List.of(), stage.connecting);
        stage.deliver(PHONE, 7, SmppMessage.HAS_HEADER, parts[0]);
        assertTrue(stage.takeMail().endsWith("\r\n\r\nThe first and the second\r\n.\r\n"));
        assertEquals(List.of(0, 0), stage.answers());
        stage.deliver(PHONE, 9, SmppMessage.HAS_HEADER, parts[0]);
        stage.pass(20);
        assertEquals(List.of(0x64), stage.answers(), "a part alone waits for 20 s");
    }

    @Test
    void aTextWithoutAnAddressIsRefusedAndItsSenderToldSo() {
        stage.deliver(PHONE, 7, "hello");
        SmppPdu.Message notice = stage.submitted();
        assertEquals("mail not sent: expected ADDRESS TEXT", MailStage.text(notice));
        stage.answer(notice, 0);
        assertEquals(List.of(0x65), stage.answers());
    }

    @Test
    void aSpanishGatewayWritesToPhonesInSpanish() {
        MailStage spanish = new MailStage(Locale.forLanguageTag("es"));
        spanish.deliver(PHONE, 7, "hola");
        assertEquals("correo no enviado: se espera NOMBRE@DOMINIO TEXTO", MailStage.text(spanish.submitted()));
        spanish.deliver(PHONE, 8, "ann@example.org Hola");
        spanish.serverUntil("MAIL").say("550 no");
        assertEquals("el correo a ann@example.org ha fallado: 550 no", MailStage.text(spanish.submitted()));
        spanish.mail("", PHONE, MailInTest.BOUNCE.formatted("").replaceAll("(?m)^Final-Recipient:.*\n", ""));
        assertEquals("el correo a su destinatario ha fallado: 5.3.0", MailStage.text(spanish.submitted()));
    }

    @Test
    void aNumberIsToldTenFailuresAnHour() {
        for (int i = 0; i < 30; i++) {
            stage.deliver(PHONE, i, "hello");
        }
        assertEquals(
                10,
                stage.pdus().stream().filter(SmppPdu.Message.class::isInstance).count());
    }

    @Test
    void aReceiverThatIsRefusedAmongOthersIsToldAndTheOthersGetTheMail() {
        stage.deliver(PHONE, 7, "ann@example.org,bob@x.org Hello");
        MailStage.Wire server = stage.serverUntil("RCPT");
        server.say("250 OK");
        server.say("550 no bob");
        server.say("354 go");
        server.say("250 taken");
        SmppPdu.Message notice = stage.submitted();
        assertEquals("mail to bob@x.org failed: 550 no bob", MailStage.text(notice));
        stage.answer(notice, 0);
        assertEquals(List.of(0), stage.answers());
    }

    @Test
    void aTextBeyondAsciiIsQuotedForAServerWithoutEightBits() {
        stage.deliver(PHONE, 7, "ann@example.org(Grüße)Hallo Wörld");
        String dialogue = stage.takeMail();
        assertTrue(dialogue.contains("Subject: =?utf-8?B?R3LDvMOfZQ==?=\r\n"), dialogue);
        assertTrue(dialogue.contains("Content-Transfer-Encoding: quoted-printable\r\n\r\nHallo W=C3=B6rld\r\n.\r\n"));

        stage.deliver(PHONE, 8, "ann@example.org Hallo Wörld");
        MailStage.Wire server = stage.serverUntil("EHLO");
        server.say("250-mx\r\n250-8BITMIME\r\n250 SIZE 1000");
        server.say("250 OK");
        server.say("250 OK");
        assertTrue(server.say("354 go").contains("8bit\r\n\r\nHallo Wörld\r\n.\r\n"));
    }

    @Test
    void aNameWithACommaIsOneReceiver() {
        stage.deliver(PHONE, 7, "ann@example.org#Smith, Ann##Hi#Text");
        assertTrue(stage.takeMail().contains("To: =?utf-8?B?U21pdGgsIEFubg==?= <ann@example.org>\r\n"));
        stage.deliver(PHONE, 8, "ann@example.org#Ann Smith##Hi#Text");
        assertTrue(stage.takeMail().contains("To: Ann Smith <ann@example.org>\r\nSubject: Hi\r\n"));
    }

    @Test
    void aSubjectCannotAddHeaders() {
        stage.deliver(PHONE, 7, "ann@example.org(Hi\r\nBcc: eve@x.org)Text");
        assertTrue(!stage.takeMail().contains("\nBcc:"));
    }

    @Test
    void aSilentConnectionToTheSmscIsCheckedAndEnded() {
        stage.smsc.taken();
        stage.timers.advance(29_000_000_000L);
        assertEquals(0, stage.smsc.taken().length);
        stage.timers.advance(30_000_000_000L);
        assertEquals(16, stage.smsc.taken().length);
        stage.timers.advance(40_000_000_000L);
        assertTrue(stage.smsc.isClosed);
        assertEquals(List.of("bound 0", "unbound"), stage.told);
    }

    @Test
    void aWrongLengthEndsTheConnectionToTheSmsc() {
        stage.smsc.protocol.received(ByteBuffer.wrap(new byte[20]));
        assertTrue(stage.smsc.isClosed);
    }
}
