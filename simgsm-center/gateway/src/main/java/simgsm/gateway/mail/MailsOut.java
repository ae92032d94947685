package simgsm.gateway.mail;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import simgsm.gateway.mail.MailJob.Part;
import simgsm.gateway.mail.MailJob.Waiting;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;
import simgsm.timer.CivilTime;
import simgsm.timer.NewestEntries;
import simgsm.timer.Timers;

/**
 * Short messages that become mail. A deliver_sm is answered after the mail server's reply: 250 by status 0, 4xx and a
 * failed connection by a temporary error, 5xx by a permanent one and a short message back. A deliver_sm that the SMSC
 * repeats meanwhile joins the mail under way; one that is repeated after the 250 is answered from memory.
 */
final class MailsOut {
    /** Time until the final dot; shorter than an SMSC waits for deliver_sm_resp. */
    private static final long UNTIL_TEXT_NANOS = TimeUnit.SECONDS.toNanos(20);
    /** Time for the answer to the final dot (RFC 5321, 4.5.3.2.6). */
    private static final long AFTER_TEXT_NANOS = TimeUnit.MINUTES.toNanos(10);

    private static final int MOST_CONNECTIONS = 8;

    private final Timers timers;
    private final CivilTime clock;
    private final MailSettings settings;
    private final MailTransport transport;
    private final Correspondences correspondences;
    private final Notices notices;
    /** By the group of the parts. */
    private final Map<String, MailJob> jobs = new HashMap<>();

    private final Queue<MailJob> queue = new ArrayDeque<>();
    private final Map<String, Boolean> mailed = new NewestEntries<>();
    private int connections;

    /** Sends short messages back. */
    interface Notices {
        /** @param then runs once the SMSC has answered, or no notice is due */
        void send(String number, String text, Runnable then);
    }

    MailsOut(
            Timers timers,
            CivilTime clock,
            MailSettings settings,
            MailTransport transport,
            Correspondences correspondences,
            Notices notices) {
        this.timers = timers;
        this.clock = clock;
        this.settings = settings;
        this.transport = transport;
        this.correspondences = correspondences;
        this.notices = notices;
    }

    void delivered(ApplicationSession session, int sequence, SmppMessage message) {
        Optional<String> number = message.source().number().map(it -> it.digits());
        if ((message.esmClass() & SmppMessage.RECEIPT) != 0) {
            session.answer(sequence, SmppStatus.OK);
            return;
        }
        DeliveredText text;
        try {
            text = DeliveredText.of(message);
        } catch (SmppViolation noText) {
            session.answer(sequence, SmppStatus.PERMANENT_APPLICATION_ERROR);
            return;
        }
        if (number.isEmpty() || !settings.mails()) {
            session.answer(sequence, SmppStatus.PERMANENT_APPLICATION_ERROR);
        } else if (mailed.containsKey(text.id())) {
            session.answer(sequence, SmppStatus.OK);
        } else {
            add(number.get(), text, new Waiting(session, sequence));
        }
    }

    private void add(String number, DeliveredText text, Waiting waiting) {
        MailJob job = jobs.computeIfAbsent(text.group(), group -> begin(new MailJob(number)));
        for (Part part : job.parts) {
            if (part.text.id().equals(text.id())) {
                part.waiting = waiting;
                return;
            }
        }
        if (job.mail != null || job.parts.stream().anyMatch(part -> part.text.part() == text.part())) {
            // Another text with the same reference, while the first is under way.
            waiting.session().answer(waiting.sequence(), SmppStatus.TEMPORARY_APPLICATION_ERROR);
            return;
        }
        job.parts.add(new Part(text, waiting));
        if (job.isWhole()) {
            address(job);
        }
    }

    private MailJob begin(MailJob job) {
        job.limit = timers.start(UNTIL_TEXT_NANOS, () -> expire(job, "421 no answer within 20 s"));
        return job;
    }

    private void expire(MailJob job, String reason) {
        if (job.client != null) {
            job.client.abort(reason);
        } else {
            failedForNow(job, reason);
        }
    }

    private void address(MailJob job) {
        String text = job.text();
        Optional<MailAddresses> addresses = MailAddresses.parse(text);
        Optional<OutgoingMail> mail =
                addresses.isPresent() ? Optional.of(mail(job, addresses.get())) : reply(job, text);
        if (mail.isEmpty()) {
            transport.failed(job.id(), "-", "no address");
            refuse(job, () -> "mail not sent: expected ADDRESS TEXT");
        } else {
            job.mail = mail.get();
            queue.add(job);
            next();
        }
    }

    private OutgoingMail mail(MailJob job, MailAddresses addresses) {
        Optional<String> answered = correspondences
                .latest(job.number)
                .filter(before -> addresses.to().contains(before.address()))
                .map(Correspondences.Mail::id)
                .filter(id -> !id.isEmpty());
        String subject = addresses.subject().isEmpty() ? "SMS from " + job.number : addresses.subject();
        return new OutgoingMail(
                job.id(),
                job.number,
                settings.domain(),
                addresses.to(),
                addresses.name(),
                subject,
                addresses.text(),
                answered,
                false,
                clock.now());
    }

    /** A text without an address answers an order that came as a mail. */
    private Optional<OutgoingMail> reply(MailJob job, String text) {
        return correspondences
                .order(job.number, job.id())
                .map(before -> new OutgoingMail(
                        job.id(),
                        job.number,
                        settings.domain(),
                        List.of(before.address()),
                        "",
                        before.subject().isEmpty() ? "SMS from " + job.number : "Re: " + before.subject(),
                        text,
                        Optional.of(before.id()).filter(id -> !id.isEmpty()),
                        true,
                        clock.now()));
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
        String to = String.join(",", job.mail.to());
        if (code < 400) {
            job.mail.to().stream()
                    .filter(each -> !refused.containsKey(each))
                    .forEach(each -> transport.mailed(job.id(), each));
            refused.forEach((each, why) -> transport.failed(job.id(), each, why));
            Runnable taken = () -> {
                job.parts.forEach(part -> mailed.put(part.text.id(), true));
                answer(job, SmppStatus.OK);
            };
            if (refused.isEmpty()) {
                taken.run();
            } else {
                String why = refused.values().iterator().next();
                notices.send(job.number, notice(refused.keySet(), why), taken);
            }
        } else if (code < 500) {
            transport.failed(job.id(), to, text);
            failedForNow(job, text);
        } else {
            transport.failed(job.id(), to, text);
            refuse(job, () -> notice(job.mail.to(), text));
        }
    }

    private static String notice(Collection<String> addresses, String why) {
        return "mail to " + SmtpClient.printable(String.join(",", addresses)) + " failed: " + SmtpClient.printable(why);
    }

    private void failedForNow(MailJob job, String reason) {
        queue.remove(job);
        if (job.mail != null && job.client == null) {
            transport.failed(job.id(), String.join(",", job.mail.to()), reason);
        }
        answer(job, SmppStatus.TEMPORARY_APPLICATION_ERROR);
    }

    /** Refuses for good; the sender is told why, unless the mail was an automatic answer. */
    private void refuse(MailJob job, Supplier<String> notice) {
        timers.cancel(job.limit);
        Runnable end = () -> answer(job, SmppStatus.PERMANENT_APPLICATION_ERROR);
        if (job.mail != null && job.mail.isAutomatic()) {
            end.run();
        } else {
            notices.send(job.number, notice.get(), end);
        }
    }

    private void answer(MailJob job, int status) {
        timers.cancel(job.limit);
        jobs.remove(job.parts.get(0).text.group());
        job.parts.forEach(part -> part.waiting.session().answer(part.waiting.sequence(), status));
    }
}
