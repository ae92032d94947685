package simgsm.center.smpp;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.Destination;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** The deliver_sm of a session that are not yet answered. */
final class DeliveryWindow {
    /** Unanswered deliver_sm at a time. */
    static final int SIZE = 100;

    /** response_timer (7.2): without an answer the attempt has failed; a later answer is ignored. */
    static final long RESPONSE_NANOS = Duration.ofSeconds(30).toNanos();

    private record Outstanding(Destination destination, Consumer<DeliveryOutcome> ended, long sentNanos) {}

    private final Timers timers;
    private final Runnable roomMade;
    private final Map<Integer, Outstanding> outstanding = new LinkedHashMap<>();
    private Timer oldest;

    /** @param roomMade is called after places have become free, by an answer or by the timer */
    DeliveryWindow(Timers timers, Runnable roomMade) {
        this.timers = timers;
        this.roomMade = roomMade;
    }

    int size() {
        return outstanding.size();
    }

    void sent(int sequence, Destination destination, Consumer<DeliveryOutcome> ended) {
        outstanding.put(sequence, new Outstanding(destination, ended, timers.nowNanos()));
        if (oldest == null) {
            oldest = timers.start(RESPONSE_NANOS, this::giveUpOldest);
        }
    }

    /** Ends the attempt with this number; an unknown number is ignored. */
    void answered(int sequence, DeliveryOutcome outcome) {
        Outstanding answered = outstanding.remove(sequence);
        if (answered != null) {
            answered.ended.accept(outcome);
            roomMade.run();
        }
    }

    private void giveUpOldest() {
        oldest = null;
        List<Outstanding> late = new ArrayList<>();
        Iterator<Outstanding> each = outstanding.values().iterator();
        while (each.hasNext() && oldest == null) {
            Outstanding next = each.next();
            long left = next.sentNanos + RESPONSE_NANOS - timers.nowNanos();
            if (left > 0) {
                oldest = timers.start(left, this::giveUpOldest);
            } else {
                each.remove();
                late.add(next);
            }
        }
        late.forEach(lost -> lost.ended.accept(DeliveryOutcome.FAILED));
        roomMade.run();
    }

    /** Ends all attempts, because the session has ended; returns their destinations. */
    List<Destination> end() {
        timers.cancel(oldest);
        List<Outstanding> lost = List.copyOf(outstanding.values());
        outstanding.clear();
        lost.forEach(each -> each.ended.accept(DeliveryOutcome.ABSENT));
        return lost.stream().map(Outstanding::destination).distinct().toList();
    }
}
