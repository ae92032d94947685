package simgsm.gateway.mail;

import simgsm.gateway.esme.TextDelivery;
import simgsm.timer.Timer;

/** One mail under way. */
final class MailJob {
    final TextDelivery delivery;
    final OutgoingMail mail;
    Timer limit;
    /** Null until the mail has its turn. */
    SmtpClient client;

    MailJob(TextDelivery delivery, OutgoingMail mail) {
        this.delivery = delivery;
        this.mail = mail;
    }
}
