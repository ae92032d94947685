package simgsm.center.smpp;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** The unanswered deliver_sm of a session, and the permission to send more. */
final class DeliveryWindow {
    /** Default maximum of unanswered deliver_sm. */
    static final int SIZE = 100;

    /** response_timer (7.2): without an answer the attempt has failed; a later answer is ignored. */
    static final Duration RESPONSE = Duration.ofSeconds(30);

    private record Outstanding(Consumer<DeliveryOutcome> ended, long deadlineNanos) {}

    private final Timers timers;
    private final Runnable roomMade;
    private final CircuitBreaker breaker;
    /** By sequence_number, in the order of sending. */
    private final Map<Integer, Outstanding> outstanding = new LinkedHashMap<>();

    private int size = SIZE;
    private Timer oldest;

    /**
     * @param session named in the log
     * @param roomMade called when the session may get deliver_sm again
     * @param abandoned called to end a session that answers nothing
     */
    DeliveryWindow(Object session, Timers timers, Runnable roomMade, Runnable abandoned) {
        this.timers = timers;
        this.roomMade = roomMade;
        breaker = new CircuitBreaker(session, timers, roomMade, abandoned);
    }

    void setSize(int deliveries) {
        size = deliveries;
    }

    int outstanding() {
        return outstanding.size();
    }

    boolean hasRoom() {
        return outstanding.size() < size && breaker.permits();
    }

    /** The lowest rank is served first. */
    int rank() {
        return breaker.rank();
    }

    void sent(int sequence, Consumer<DeliveryOutcome> ended) {
        outstanding.put(sequence, new Outstanding(ended, timers.nowNanos() + RESPONSE.toNanos()));
        breaker.sent();
        if (oldest == null) {
            oldest = timers.start(RESPONSE.toNanos(), this::giveUpLate);
        }
    }

    /** Ends the attempt with this number; an unknown number is ignored. */
    void answered(int sequence, DeliveryOutcome outcome) {
        Outstanding answered = outstanding.remove(sequence);
        if (answered == null) {
            return;
        }
        if (outcome == DeliveryOutcome.DELIVERED || outcome == DeliveryOutcome.REFUSED) {
            breaker.succeeded();
        } else {
            breaker.refused();
        }
        answered.ended.accept(outcome);
        roomMade.run();
    }

    private void giveUpLate() {
        oldest = null;
        List<Outstanding> late = new ArrayList<>();
        Iterator<Outstanding> each = outstanding.values().iterator();
        while (each.hasNext() && oldest == null) {
            Outstanding next = each.next();
            long leftNanos = next.deadlineNanos - timers.nowNanos();
            if (leftNanos > 0) {
                oldest = timers.start(leftNanos, this::giveUpLate);
            } else {
                each.remove();
                late.add(next);
            }
        }
        breaker.unanswered(late.size());
        DeliveryOutcome outcome = breaker.hasEndedSession() ? DeliveryOutcome.WITHDRAWN : DeliveryOutcome.UNANSWERED;
        late.forEach(lost -> lost.ended.accept(outcome));
        roomMade.run();
    }

    /** Ends all attempts, because the session has ended. */
    void end() {
        timers.cancel(oldest);
        breaker.end();
        List<Outstanding> lost = List.copyOf(outstanding.values());
        outstanding.clear();
        lost.forEach(each -> each.ended.accept(DeliveryOutcome.WITHDRAWN));
    }
}
