package simgsm.gateway.mail;

import java.nio.charset.StandardCharsets;
import java.time.InstantSource;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.gateway.esme.Application;
import simgsm.gateway.esme.TcpProtocol;
import simgsm.gateway.esme.TextDelivery;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.Tlv;
import simgsm.sms.GsmAlphabet;
import simgsm.timer.BoundedMap;
import simgsm.timer.RecentCounts;
import simgsm.timer.Timers;

/**
 * Joins one application of the SMSC with mail. Loops end here: automatic mail is neither an order nor answered, and one
 * address sends at most 10 mails an hour to one number.
 */
public final class MailGateway {
    private static final int MOST_AN_HOUR = 10;
    /** TP-PID of Internet electronic mail (TS 23.040, 9.2.3.9). */
    private static final int MAIL_PROTOCOL = 0x32;

    private static final int GSM = 0;
    private static final int UCS2 = 8;
    private static final String TAKEN = "250 2.0.0 taken by the network";

    private final Timers timers;
    private final MailSettings settings;
    private final MailTransport transport;
    private final Correspondences correspondences;
    private final MailsOut out;
    private final RecentCounts pairs = new RecentCounts(MOST_AN_HOUR, TimeUnit.HOURS.toNanos(1));
    private final RecentCounts noticesTo = new RecentCounts(MOST_AN_HOUR, TimeUnit.HOURS.toNanos(1));
    /** Mails taken, by Message-ID, number and sender: one whose 250 was lost is not submitted twice. */
    private final Map<String, Boolean> taken = new BoundedMap<>();

    private final Application application;

    public MailGateway(
            Timers timers,
            InstantSource clock,
            MailSettings settings,
            MailTransport transport,
            Application.Listener binds) {
        this.timers = timers;
        this.settings = settings;
        this.transport = transport;
        application = new Application(timers, settings.bind(), binds, this::whole);
        correspondences = new Correspondences(settings.bind().number().digits(), clock);
        out = new MailsOut(timers, clock, settings, transport, correspondences, this::notice, application::answer);
    }

    public Application application() {
        return application;
    }

    private void whole(TextDelivery delivery) {
        out.whole(delivery);
    }

    /** The protocol of a mail client's connection. @param from the client's address */
    public TcpProtocol accepted(String from) {
        return new SmtpSession(
                timers,
                settings.domain(),
                this::mail,
                reply -> transport.refused(from, Integer.parseInt(reply.substring(0, 3)), reply));
    }

    private void notice(String number, String text, Runnable then) {
        if (!application.isBound() || noticesTo.isFull(number, timers.nowNanos())) {
            then.run();
            return;
        }
        noticesTo.count(number, timers.nowNanos());
        // Without the signs of an order, whatever the address holds.
        String harmless = text.replace('*', '.').replace('#', '.');
        application.submit(submission(settings.bind().number().digits(), number, harmless), status -> then.run());
    }

    /** The only automatic mail that reaches a phone is a notice of non-delivery, which is never refused for good. */
    private void mail(String number, String sender, String octets, Consumer<String> reply) {
        IncomingMail mail = IncomingMail.read(sender, octets);
        String pair = number + " " + sender.toLowerCase(Locale.ROOT);
        String key = pair + " " + mail.id();
        if (mail.isAutomatic() && mail.failure().isEmpty()) {
            reply.accept(sender.isEmpty() ? "250 2.0.0 dropped" : "550 5.7.1 automatic mail is not taken");
        } else if (!mail.id().isEmpty() && taken.containsKey(key)) {
            reply.accept(TAKEN);
        } else if (!application.isBound()) {
            reply.accept("451 4.3.0 the network does not answer");
        } else if (mail.isAutomatic()) {
            notice(number, words(mail.failure().get()), () -> reply.accept(TAKEN));
        } else if (pairs.isFull(pair, timers.nowNanos())) {
            reply.accept("550 5.7.1 more than " + MOST_AN_HOUR + " an hour to one number");
        } else {
            String text = mail.order().orElse(sender + " " + mail.text());
            String own = correspondences.add(new Correspondences.Mail(number, sender, mail.id(), mail.subject()));
            application.submit(submission(own, number, text), status -> {
                if (status == SmppStatus.OK) {
                    pairs.count(pair, timers.nowNanos());
                    taken.put(key, true);
                }
                reply.accept(reply(status));
            });
        }
    }

    private String words(IncomingMail.Failure failure) {
        String receiver = failure.receiver().isEmpty() ? settings.words().of("mail.receiver") : failure.receiver();
        return settings.words().of("mail.failed", receiver, failure.status());
    }

    private static String reply(int status) {
        if (status == SmppStatus.OK) {
            return TAKEN;
        } else if (status == SmppStatus.INVALID_DESTINATION) {
            return "550 5.1.1 unknown number";
        } else if (status == Application.LOST || SmppStatus.mayPass(status)) {
            return "451 4.3.0 the network does not take it now";
        }
        return "554 5.3.0 the network refuses it, status 0x%02x".formatted(status);
    }

    private static SmppMessage submission(String from, String number, String text) {
        boolean isGsm = GsmAlphabet.encodes(text);
        byte[] octets = isGsm ? GsmAlphabet.encode(text) : text.getBytes(StandardCharsets.UTF_16BE);
        boolean isShort = octets.length <= SmppMessage.MAX_SHORT_MESSAGE;
        OctetString content = OctetString.of(octets);
        return SmppMessage.of(
                new SmppAddress(0, 1, from),
                new SmppAddress(1, 1, number),
                0,
                MAIL_PROTOCOL,
                isGsm ? GSM : UCS2,
                isShort ? content : OctetString.of(new byte[0]),
                isShort ? List.of() : List.of(new Tlv(Tlv.MESSAGE_PAYLOAD, content)));
    }
}
