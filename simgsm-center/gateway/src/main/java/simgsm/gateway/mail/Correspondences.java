package simgsm.gateway.mail;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.Optional;
import simgsm.timer.NewestEntries;

/** The mails that became short messages, so that answers find their way back; of at most 10 000 numbers. */
final class Correspondences {
    private static final int MOST_ORDERS = 100;

    /**
     * A mail that became a short message.
     *
     * @param id its Message-ID with brackets, may be empty
     */
    record Mail(String address, String id, String subject) {}

    private final Map<String, Mail> latest = new NewestEntries<>();
    /** Orders by number, the oldest without an answer first; the last one stays. */
    private final Map<String, Deque<Mail>> orders = new NewestEntries<>();
    /** The order that a text without an address answers, also when the SMSC repeats the text. */
    private final Map<String, Mail> answered = new NewestEntries<>();

    void add(String number, Mail mail, boolean isOrder) {
        latest.put(number, mail);
        if (isOrder) {
            Deque<Mail> waiting = orders.computeIfAbsent(number, it -> new ArrayDeque<>());
            waiting.add(mail);
            if (waiting.size() > MOST_ORDERS) {
                waiting.remove();
            }
        }
    }

    /** The latest mail to a number. */
    Optional<Mail> latest(String number) {
        return Optional.ofNullable(latest.get(number));
    }

    /** The order that is answered by the text of this id. */
    Optional<Mail> order(String number, String textId) {
        Deque<Mail> waiting = orders.get(number);
        if (waiting != null && !answered.containsKey(textId)) {
            answered.put(textId, waiting.size() > 1 ? waiting.remove() : waiting.element());
        }
        return Optional.ofNullable(answered.get(textId));
    }
}
