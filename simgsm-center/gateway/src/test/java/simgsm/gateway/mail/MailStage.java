package simgsm.gateway.mail;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.concurrent.TimeUnit;
import simgsm.air.Msisdn;
import simgsm.console.TextBundle;
import simgsm.gateway.esme.Application;
import simgsm.gateway.esme.BindSettings;
import simgsm.gateway.esme.TcpProtocol;
import simgsm.gateway.esme.TcpSocket;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppFramer;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppViolation;
import simgsm.smpp.Tlv;
import simgsm.sms.GsmAlphabet;
import simgsm.timer.Timers;

/** The core of mail between an SMSC, a mail server and mail clients that a test plays; the clock moves by hand. */
final class MailStage implements MailTransport, Application.Listener {
    /** One connection, as the test sees it. */
    static final class Wire implements TcpSocket {
        final TcpProtocol protocol;
        private byte[] sent = new byte[0];
        boolean isClosed;

        Wire(TcpProtocol protocol) {
            this.protocol = protocol;
            protocol.connected(this);
        }

        @Override
        public void send(byte[] octets) {
            byte[] all = java.util.Arrays.copyOf(sent, sent.length + octets.length);
            System.arraycopy(octets, 0, all, sent.length, octets.length);
            sent = all;
        }

        @Override
        public void closeWhenSent() {
            isClosed = true;
        }

        byte[] taken() {
            byte[] all = sent;
            sent = new byte[0];
            return all;
        }

        String text() {
            return new String(taken(), StandardCharsets.UTF_8);
        }

        /** Sends a line; returns what comes back. */
        String say(String line) {
            protocol.received(ByteBuffer.wrap((line + "\r\n").getBytes(StandardCharsets.UTF_8)));
            return text();
        }
    }

    final Timers timers = new Timers();
    final List<String> told = new ArrayList<>();
    final List<TcpProtocol> connecting = new ArrayList<>();
    MailGateway gateway;
    Wire smsc;
    private final List<SmppPdu> pdus = new ArrayList<>();
    private SmppFramer framer;
    private final TextBundle words;
    private int sequence = 100;

    MailStage() {
        this(Locale.ENGLISH);
    }

    /** @param language of the notices to phones */
    MailStage(Locale language) {
        Locale bundle = TextBundle.bundleLocale(language);
        words = new TextBundle(ResourceBundle.getBundle("simgsm.gateway.messages", bundle), bundle);
        restart();
    }

    /** A new gateway, as after kill -9; the SMSC binds it. */
    void restart() {
        connecting.clear();
        gateway = new MailGateway(
                timers,
                () -> Instant.EPOCH.plusNanos(timers.nowNanos()),
                new MailSettings(new BindSettings(new Msisdn("6245"), "^6245", "mail", ""), "sms.example", true, words),
                this,
                this);
        smsc = new Wire(gateway.application().connection());
        framer = new SmppFramer();
        SmppPdu.Bind bind = (SmppPdu.Bind) pdus().get(0);
        toCore(new SmppPdu.BindResponse(bind.command(), 0, bind.sequence(), "test"));
    }

    void pass(long seconds) {
        for (long second = 0; second < seconds; second++) {
            timers.advance(timers.nowNanos() + TimeUnit.SECONDS.toNanos(1));
            collect();
        }
    }

    // The SMSC.

    void toCore(SmppPdu pdu) {
        smsc.protocol.received(ByteBuffer.wrap(SmppCodec.encode(pdu)));
    }

    /** PDUs sent by the application, without those that check the link. */
    List<SmppPdu> pdus() {
        collect();
        List<SmppPdu> all = List.copyOf(pdus);
        pdus.clear();
        return all;
    }

    private void collect() {
        framer.accept(ByteBuffer.wrap(smsc.taken()));
        try {
            while (framer.hasNext()) {
                SmppPdu pdu = framer.next();
                if (pdu.command() == SmppCommand.ENQUIRE_LINK) {
                    toCore(new SmppPdu.PlainResponse(pdu.command(), 0, pdu.sequence()));
                } else {
                    pdus.add(pdu);
                }
            }
        } catch (SmppViolation e) {
            throw new AssertionError(e);
        }
    }

    /** Statuses of deliver_sm_resp, in order. */
    List<Integer> answers() {
        return pdus().stream()
                .filter(SmppPdu.MessageResponse.class::isInstance)
                .map(each -> ((SmppPdu.MessageResponse) each).status())
                .toList();
    }

    /** The only submit_sm that waits. */
    SmppPdu.Message submitted() {
        return pdus().stream()
                .filter(SmppPdu.Message.class::isInstance)
                .map(SmppPdu.Message.class::cast)
                .reduce((one, other) -> {
                    throw new AssertionError("two submissions");
                })
                .orElseThrow();
    }

    static String text(SmppPdu.Message message) {
        try {
            byte[] octets = message.message().content().toArray();
            return message.message().dataCoding() == 0
                    ? GsmAlphabet.decode(octets)
                    : new String(octets, StandardCharsets.UTF_16BE);
        } catch (SmppViolation e) {
            throw new AssertionError(e);
        }
    }

    void answer(SmppPdu.Message message, int status) {
        toCore(new SmppPdu.MessageResponse(SmppCommand.SUBMIT_SM, status, message.sequence(), status == 0 ? "1" : ""));
    }

    /** deliver_sm of a text of ASCII. @param reference the SMSC's, equal when it sends the message again */
    int deliver(String from, int reference, String text) {
        return deliver(from, reference, 0, text.getBytes(StandardCharsets.ISO_8859_1));
    }

    int deliver(String from, int reference, int esmClass, byte[] octets) {
        return deliver(from, "6245", reference, esmClass, octets);
    }

    /** The receiver of a message answers it. */
    int reply(SmppPdu.Message message, int reference, String text) {
        String from = message.message().destination().value();
        String to = message.message().source().value();
        return deliver(from, to, reference, text);
    }

    int deliver(String from, String to, int reference, String text) {
        return deliver(from, to, reference, 0, text.getBytes(StandardCharsets.ISO_8859_1));
    }

    private int deliver(String from, String to, int reference, int esmClass, byte[] octets) {
        sequence++;
        toCore(new SmppPdu.Message(
                SmppCommand.DELIVER_SM,
                sequence,
                SmppMessage.of(
                        new SmppAddress(1, 1, from),
                        new SmppAddress(1, 1, to),
                        esmClass,
                        0,
                        3,
                        OctetString.of(octets),
                        List.of(Tlv.ofTwoOctets(Tlv.USER_MESSAGE_REFERENCE, reference)))));
        return sequence;
    }

    // The mail server.

    Wire server() {
        return new Wire(connecting.remove(0));
    }

    /** A mail server that accepts all until this step: GREETING, MAIL, RCPT, DATA, TEXT. */
    Wire serverUntil(String step) {
        Wire server = server();
        for (String each : List.of("GREETING", "EHLO", "MAIL", "RCPT", "DATA", "TEXT")) {
            if (each.equals(step)) {
                break;
            }
            String reply = each.equals("GREETING") ? "220 hi" : each.equals("DATA") ? "354 go" : "250 OK";
            server.protocol.received(ByteBuffer.wrap((reply + "\r\n").getBytes(StandardCharsets.US_ASCII)));
        }
        return server;
    }

    /** Takes one mail whole; returns the dialogue. */
    String takeMail() {
        Wire server = serverUntil("TEXT");
        String dialogue = server.text();
        server.say("250 taken");
        return dialogue;
    }

    // A mail client.

    /** Sends a mail that the SMSC answers by this status; returns its submission. */
    SmppPdu.Message mailed(String from, String to, String content, int status) {
        mail(from, to, content);
        SmppPdu.Message message = submitted();
        answer(message, status);
        return message;
    }

    /** Sends a mail; returns the reply, empty while there is none. */
    Wire mail(String from, String to, String content) {
        Wire client = new Wire(gateway.accepted("192.0.2.1"));
        client.say("EHLO client.example");
        client.say("MAIL FROM:<" + from + ">");
        client.say("RCPT TO:<" + to + "@sms.example>");
        client.say("DATA");
        client.protocol.received(
                ByteBuffer.wrap((content.replace("\n", "\r\n") + "\r\n.\r\n").getBytes(StandardCharsets.UTF_8)));
        return client;
    }

    @Override
    public void connect(TcpProtocol client) {
        connecting.add(client);
    }

    @Override
    public void mailed(String id, String to) {
        told.add("mailed " + to);
    }

    @Override
    public void failed(String id, String to, String text) {
        told.add("failed " + to + " " + text);
    }

    @Override
    public void refused(String from, int cause, String text) {
        told.add("refused " + cause);
    }

    @Override
    public void bound(int status) {
        told.add("bound " + status);
    }

    @Override
    public void unbound() {
        told.add("unbound");
    }
}
