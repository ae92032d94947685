package simgsm.gateway.mail;

import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.TimeUnit;
import java.util.function.ObjIntConsumer;
import simgsm.gateway.esme.TextDelivery;
import simgsm.smpp.SmppStatus;
import simgsm.timer.Timers;

/**
 * Short messages that become mail. A deliver_sm is answered after the mail server's reply: 250 by status 0, 4xx and a
 * failed connection by a temporary error, 5xx by a permanent one and a short message back.
 */
final class MailsOut {
    /** Time until the final dot; shorter than an SMSC waits for deliver_sm_resp. */
    private static final long UNTIL_TEXT_NANOS = TimeUnit.SECONDS.toNanos(20);
    /** Time for the answer to the final dot (RFC 5321, 4.5.3.2.6). */
    private static final long AFTER_TEXT_NANOS = TimeUnit.MINUTES.toNanos(10);

    private static final int MOST_CONNECTIONS = 8;

    private final Timers timers;
    private final InstantSource clock;
    private final MailSettings settings;
    private final MailTransport transport;
    private final Correspondences correspondences;
    private final Notices notices;
    private final ObjIntConsumer<TextDelivery> answers;
    private final Queue<MailJob> queue = new ArrayDeque<>();
    private int connections;

    /** Sends short messages back. */
    interface Notices {
        /** @param then runs once the SMSC has answered, or no notice is due */
        void send(String number, String text, Runnable then);
    }

    MailsOut(
            Timers timers,
            InstantSource clock,
            MailSettings settings,
            MailTransport transport,
            Correspondences correspondences,
            Notices notices,
            ObjIntConsumer<TextDelivery> answers) {
        this.timers = timers;
        this.clock = clock;
        this.settings = settings;
        this.transport = transport;
        this.correspondences = correspondences;
        this.notices = notices;
        this.answers = answers;
    }

    /** A text without a receiver is refused for good, and its sender told so; not a late answer, of a robot perhaps. */
    void whole(TextDelivery delivery) {
        if (!settings.mails()) {
            transport.failed(delivery.id(), "-", "no mail server, --mail-to is missing");
            answers.accept(delivery, SmppStatus.PERMANENT_APPLICATION_ERROR);
            return;
        }
        Optional<MailAddresses> addresses = MailAddresses.parse(delivery.text());
        Optional<OutgoingMail> mail =
                addresses.isPresent() ? Optional.of(mail(delivery, addresses.get())) : reply(delivery);
        if (mail.isEmpty()) {
            transport.failed(delivery.id(), "-", "no address");
            Runnable end = () -> answers.accept(delivery, SmppStatus.PERMANENT_APPLICATION_ERROR);
            if (delivery.to().equals(settings.bind().number().digits())) {
                notices.send(delivery.number(), settings.words().of("mail.expected"), end);
            } else {
                end.run();
            }
        } else {
            MailJob job = new MailJob(delivery, mail.get());
            job.limit = timers.start(UNTIL_TEXT_NANOS, () -> expire(job, "421 no answer within 20 s"));
            queue.add(job);
            next();
        }
    }

    private void expire(MailJob job, String reason) {
        if (job.client != null) {
            job.client.abort(reason);
        } else {
            queue.remove(job);
            failedForNow(job, reason);
        }
    }

    private OutgoingMail mail(TextDelivery delivery, MailAddresses addresses) {
        Optional<String> answered = correspondences
                .answered(delivery)
                .filter(before -> addresses.to().contains(before.address()))
                .map(Correspondences.Mail::id)
                .filter(id -> !id.isEmpty());
        String subject = addresses.subject().isEmpty() ? subject(delivery) : addresses.subject();
        return new OutgoingMail(
                delivery.id(),
                delivery.number(),
                settings.domain(),
                addresses.to(),
                addresses.name(),
                subject,
                addresses.text(),
                answered,
                false,
                clock.instant());
    }

    private String subject(TextDelivery delivery) {
        return settings.words().of("mail.subject", delivery.number());
    }

    /** A text without an address to a mail's number answers it. A robot's is not told from a person's: it is automatic. */
    private Optional<OutgoingMail> reply(TextDelivery delivery) {
        return correspondences
                .answered(delivery)
                .map(before -> new OutgoingMail(
                        delivery.id(),
                        delivery.number(),
                        settings.domain(),
                        List.of(before.address()),
                        "",
                        before.subject().isEmpty() ? subject(delivery) : "Re: " + before.subject(),
                        delivery.text(),
                        Optional.of(before.id()).filter(id -> !id.isEmpty()),
                        true,
                        clock.instant()));
    }

    private void next() {
        while (connections < MOST_CONNECTIONS && !queue.isEmpty()) {
            MailJob job = queue.remove();
            connections++;
            job.client = new SmtpClient(job.mail, new SmtpClient.Listener() {
                @Override
                public void textSent() {
                    timers.cancel(job.limit);
                    job.limit = timers.start(AFTER_TEXT_NANOS, () -> expire(job, "421 no answer to the text"));
                }

                @Override
                public void ended(int code, String text, Map<String, String> refused) {
                    connections--;
                    MailsOut.this.ended(job, code, text, refused);
                    next();
                }
            });
            transport.connect(job.client);
        }
    }

    private void ended(MailJob job, int code, String text, Map<String, String> refused) {
        if (code < 400) {
            job.mail.to().stream()
                    .filter(each -> !refused.containsKey(each))
                    .forEach(each -> transport.mailed(job.mail.id(), each));
            refused.forEach((each, why) -> transport.failed(job.mail.id(), each, why));
            Runnable taken = () -> answer(job, SmppStatus.OK);
            if (refused.isEmpty()) {
                taken.run();
            } else {
                String why = refused.values().iterator().next();
                notices.send(job.mail.number(), notice(refused.keySet(), why), taken);
            }
        } else if (code < 500) {
            failedForNow(job, text);
        } else {
            refuse(job, text);
        }
    }

    private String notice(Collection<String> addresses, String why) {
        String to = SmtpClient.printable(String.join(",", addresses));
        return settings.words().of("mail.failed", to, SmtpClient.printable(why));
    }

    private void failedForNow(MailJob job, String reason) {
        transport.failed(job.mail.id(), String.join(",", job.mail.to()), reason);
        answer(job, SmppStatus.TEMPORARY_APPLICATION_ERROR);
    }

    /** Refuses for good; the sender is told why, unless the mail was an automatic answer. */
    private void refuse(MailJob job, String reason) {
        timers.cancel(job.limit);
        transport.failed(job.mail.id(), String.join(",", job.mail.to()), reason);
        Runnable end = () -> answer(job, SmppStatus.PERMANENT_APPLICATION_ERROR);
        if (job.mail.isAutomatic()) {
            end.run();
        } else {
            notices.send(job.mail.number(), notice(job.mail.to(), reason), end);
        }
    }

    private void answer(MailJob job, int status) {
        timers.cancel(job.limit);
        answers.accept(job.delivery, status);
    }
}
