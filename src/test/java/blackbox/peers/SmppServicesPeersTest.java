package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.RunningProgram;
import blackbox.Scenario;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jsmpp.bean.Address;
import org.jsmpp.bean.AlertNotification;
import org.jsmpp.bean.Alphabet;
import org.jsmpp.bean.BindType;
import org.jsmpp.bean.DataSm;
import org.jsmpp.bean.DeliverSm;
import org.jsmpp.bean.ESMClass;
import org.jsmpp.bean.GeneralDataCoding;
import org.jsmpp.bean.NumberingPlanIndicator;
import org.jsmpp.bean.RegisteredDelivery;
import org.jsmpp.bean.ReplaceIfPresentFlag;
import org.jsmpp.bean.TypeOfNumber;
import org.jsmpp.bean.UnsuccessDelivery;
import org.jsmpp.extra.ProcessRequestException;
import org.jsmpp.session.BindParameter;
import org.jsmpp.session.DataSmResult;
import org.jsmpp.session.MessageReceiverListener;
import org.jsmpp.session.SMPPSession;
import org.jsmpp.session.Session;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Applications that were written elsewhere refuse a message, and submit to several receivers, at a later time, and what
 * replaces an earlier message: smpplib, node-smpp and jSMPP.
 */
@Tag("peer")
class SmppServicesPeersTest {
    private static final String APPLICATION = "5550300";
    private static final int THROTTLED = 0x58;

    /** A phone from which "bad" and "good" wait for the application. */
    private static RunningProgram begin(Scenario scenario) {
        scenario.center("--smpp", "0");
        RunningProgram phone = scenario.phone(Scenario.PHONE);
        for (String text : List.of("bad", "good")) {
            phone.say("sms " + APPLICATION + " " + text);
            phone.expect("sms-sent", "to", APPLICATION);
        }
        return phone;
    }

    private static void expect(RunningProgram phone, String... texts) {
        for (String text : texts) {
            phone.expect("sms", "from", APPLICATION, "text", text);
        }
    }

    /** The one refused message comes again; the other one does not wait for it. */
    private static void assertBadGoodBad(List<String> lines) {
        List<String> got =
                lines.stream().filter(line -> line.startsWith("got ")).toList();
        assertEquals(List.of("got bad", "got good", "got bad"), got);
    }

    @Test
    void smpplibRefusesAMessageAndSchedulesOne() throws Exception {
        Peer.require(Peer.PYTHON.run("-c", "import smpplib").status() == 0, "smpplib (Python)");
        try (Scenario scenario = new Scenario("smpplib refuses and schedules")) {
            RunningProgram phone = begin(scenario);
            String printed = Peer.PYTHON
                    .run(
                            Peer.source("smpplib_services.py"),
                            String.valueOf(scenario.smppPort()),
                            APPLICATION,
                            Scenario.PHONE)
                    .expectSuccess();
            assertBadGoodBad(printed.lines().toList());
            expect(phone, "now", "later");
        }
    }

    @Test
    void nodeSmppUsesEveryService() throws Exception {
        Peer.require(Peer.NODE.run("-e", "require('smpp')").status() == 0, "smpp (Node)");
        try (Scenario scenario = new Scenario("node-smpp uses every service")) {
            RunningProgram phone = begin(scenario);
            String printed = Peer.NODE
                    .run(
                            Peer.source("node_smpp_services.js"),
                            String.valueOf(scenario.smppPort()),
                            APPLICATION,
                            Scenario.PHONE)
                    .expectSuccess();
            assertBadGoodBad(printed.lines().toList());
            assertTrue(printed.contains("multi 0 Letters:11"), printed);
            assertEquals(2, printed.lines().filter("scheduled 0"::equals).count(), printed);
            assertTrue(printed.contains("replaced 0"), printed);
            expect(phone, "all", "now", "new", "later");
        }
    }

    @Test
    void jsmppUsesEveryService() throws Exception {
        try (Scenario scenario = new Scenario("jSMPP uses every service")) {
            RunningProgram phone = begin(scenario);
            BlockingQueue<String> got = new LinkedBlockingQueue<>();
            SMPPSession session = new SMPPSession();
            session.setMessageReceiverListener(new Refusing(got));
            // With its usual three threads the library takes two deliver_sm of one window in either order.
            session.setPduProcessorDegree(1);
            session.setTransactionTimer(TimeUnit.SECONDS.toMillis(RunningProgram.PATIENCE_SECONDS));
            session.connectAndBind(
                    "127.0.0.1",
                    scenario.smppPort(),
                    new BindParameter(
                            BindType.BIND_TRX,
                            "jsmpp",
                            "",
                            "",
                            TypeOfNumber.INTERNATIONAL,
                            NumberingPlanIndicator.ISDN,
                            APPLICATION));
            UnsuccessDelivery[] refused = toAll(session);
            assertEquals(1, refused.length);
            assertEquals("Letters", refused[0].getDestinationAddress().getAddress());
            assertEquals(0x0b, refused[0].getErrorStatusCode());
            submit(session, "later", "000000000006000R");
            submit(session, "now", null);
            String old = submit(session, "old", "000000010000000R");
            session.replaceShortMessage(
                    old,
                    TypeOfNumber.INTERNATIONAL,
                    NumberingPlanIndicator.ISDN,
                    APPLICATION,
                    "000000000001000R",
                    null,
                    new RegisteredDelivery(0),
                    (byte) 0,
                    octets("new"));
            assertBadGoodBad(List.of(taken(got), taken(got), taken(got)));
            expect(phone, "all", "now", "new", "later");
            session.unbindAndClose();
        }
    }

    /** Refuses the first text "bad" with 0x58. */
    private static final class Refusing implements MessageReceiverListener {
        private final BlockingQueue<String> got;
        private boolean hasRefused;

        Refusing(BlockingQueue<String> got) {
            this.got = got;
        }

        @Override
        public synchronized void onAcceptDeliverSm(DeliverSm delivered) throws ProcessRequestException {
            String text = new String(delivered.getShortMessage(), StandardCharsets.ISO_8859_1);
            got.add("got " + text);
            if (text.equals("bad") && !hasRefused) {
                hasRefused = true;
                throw new ProcessRequestException("throttled", THROTTLED);
            }
        }

        @Override
        public void onAcceptAlertNotification(AlertNotification notification) {}

        @Override
        public DataSmResult onAcceptDataSm(DataSm data, Session source) {
            return null;
        }
    }

    private static byte[] octets(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    private static UnsuccessDelivery[] toAll(SMPPSession session) throws Exception {
        return session.submitMultiple(
                        "",
                        TypeOfNumber.INTERNATIONAL,
                        NumberingPlanIndicator.ISDN,
                        APPLICATION,
                        new Address[] {
                            new Address(TypeOfNumber.INTERNATIONAL, NumberingPlanIndicator.ISDN, Scenario.PHONE),
                            new Address(TypeOfNumber.ALPHANUMERIC, NumberingPlanIndicator.UNKNOWN, "Letters")
                        },
                        new ESMClass(),
                        (byte) 0,
                        (byte) 0,
                        null,
                        null,
                        new RegisteredDelivery(0),
                        ReplaceIfPresentFlag.DEFAULT,
                        new GeneralDataCoding(Alphabet.ALPHA_DEFAULT),
                        (byte) 0,
                        octets("all"))
                .getUnsuccessDeliveries();
    }

    private static String submit(SMPPSession session, String text, String schedule) throws Exception {
        return session.submitShortMessage(
                        "",
                        TypeOfNumber.INTERNATIONAL,
                        NumberingPlanIndicator.ISDN,
                        APPLICATION,
                        TypeOfNumber.INTERNATIONAL,
                        NumberingPlanIndicator.ISDN,
                        Scenario.PHONE,
                        new ESMClass(),
                        (byte) 0,
                        (byte) 0,
                        schedule,
                        null,
                        new RegisteredDelivery(0),
                        (byte) 0,
                        new GeneralDataCoding(Alphabet.ALPHA_DEFAULT),
                        (byte) 0,
                        octets(text))
                .getMessageId();
    }

    private static String taken(BlockingQueue<String> texts) throws InterruptedException {
        String text = texts.poll(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
        assertTrue(text != null, "no text came");
        return text;
    }
}
