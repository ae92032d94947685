package simgsm.gateway.mail;

import java.util.ArrayList;
import java.util.List;
import simgsm.timer.Timer;

/** One mail under way, and the deliver_sm that wait for its end. */
final class MailJob {
    /** A deliver_sm without an answer. */
    record Waiting(ApplicationSession session, int sequence) {}

    /** A part of the text; {@code waiting} is the latest deliver_sm that brought it. */
    static final class Part {
        final DeliveredText text;
        Waiting waiting;

        Part(DeliveredText text, Waiting waiting) {
            this.text = text;
            this.waiting = waiting;
        }
    }

    final String number;
    final List<Part> parts = new ArrayList<>();
    Timer limit;
    /** Null until the text is whole. */
    OutgoingMail mail;
    /** Null until the mail has its turn. */
    SmtpClient client;

    MailJob(String number) {
        this.number = number;
    }

    boolean isWhole() {
        return parts.size() == parts.get(0).text.parts();
    }

    String text() {
        StringBuilder text = new StringBuilder();
        parts.sort((one, other) -> Integer.compare(one.text.part(), other.text.part()));
        parts.forEach(part -> text.append(part.text.text()));
        return text.toString();
    }

    String id() {
        return parts.get(0).text.id();
    }
}
