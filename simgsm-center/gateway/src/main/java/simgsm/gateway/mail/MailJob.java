package simgsm.gateway.mail;

import simgsm.gateway.esme.Delivery;
import simgsm.timer.Timer;

/** One mail under way. */
final class MailJob {
    final Delivery delivery;
    final OutgoingMail mail;
    Timer limit;
    /** Null until the mail has its turn. */
    SmtpClient client;

    MailJob(Delivery delivery, OutgoingMail mail) {
        this.delivery = delivery;
        this.mail = mail;
    }
}
