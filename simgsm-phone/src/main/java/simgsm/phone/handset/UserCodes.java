package simgsm.phone.handset;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import simgsm.station.context.StationEvent;
import simgsm.station.context.UssdEnding;

/**
 * USSD codes by which the phone tells the network of its user: the name, at each registration, and results of lessons; one
 * after the other, each until the network has answered.
 */
public final class UserCodes {
    /** More than the steps of all lessons. */
    private static final int MOST = 500;

    private static final Set<UssdEnding> UNANSWERED =
            EnumSet.of(UssdEnding.NO_SERVICE, UssdEnding.NO_ANSWER, UssdEnding.CANCELLED);

    private final Predicate<String> ussd;
    private final Deque<String> waiting = new ArrayDeque<>();
    private Optional<String> name = Optional.empty();
    private boolean isRegistered;
    private boolean isSent;

    /** @param ussd sends a code; false while another dialogue is under way */
    UserCodes(Predicate<String> ussd) {
        this.ussd = ussd;
    }

    /** The code of a name, for which USSD may have no room. */
    public static String ofName(String text) {
        return "*300*" + text + "#";
    }

    public void name(String text) {
        name.ifPresent(waiting::remove);
        name = Optional.of(ofName(text));
        add(name.get());
    }

    /** @param fields lesson, step, result, tries, hints */
    public void result(String... fields) {
        add("*301*" + String.join("*", fields) + "#");
    }

    private void add(String code) {
        if (waiting.size() < MOST) {
            waiting.add(code);
        }
        send();
    }

    /** An event of the station: an answer, or a chance to send. What got no answer is sent again at the next registration. */
    void accept(StationEvent event) {
        if (event instanceof StationEvent.StationRegistered) {
            isRegistered = true;
            name.filter(code -> !waiting.contains(code)).ifPresent(waiting::addFirst);
            send();
        } else if (event instanceof StationEvent.StationUnregistered) {
            isRegistered = false;
        } else if (event instanceof StationEvent.OfUssd) {
            boolean isUnanswered = event instanceof StationEvent.UssdEnded end && UNANSWERED.contains(end.how());
            if (isSent && !isUnanswered) {
                waiting.remove();
            }
            isSent = false;
            if (!isUnanswered) {
                send();
            }
        }
    }

    private void send() {
        if (isRegistered && !isSent && !waiting.isEmpty()) {
            isSent = ussd.test(waiting.peek());
        }
    }
}
