package simgsm.center.smpp;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.DeliveryReceipt;
import simgsm.center.smsc.Recipient;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** The deliver_sm of a session that are not answered yet. */
final class DeliveryWindow {
    /** How many an application may leave unanswered before it gets no more. */
    static final int SIZE = 100;

    /** response_timer (7.2): later answers come to nothing, the message is tried again. */
    static final long RESPONSE_NANOS = Duration.ofSeconds(30).toNanos();

    private record Outstanding(Recipient receiver, DeliveryReceipt receipt, long sentNanos) {}

    private final Timers timers;
    private final Map<Integer, Outstanding> outstanding = new LinkedHashMap<>();
    private Timer oldest;

    DeliveryWindow(Timers timers) {
        this.timers = timers;
    }

    int size() {
        return outstanding.size();
    }

    void sent(int sequence, Recipient receiver, DeliveryReceipt receipt) {
        outstanding.put(sequence, new Outstanding(receiver, receipt, timers.nowNanos()));
        if (oldest == null) {
            oldest = timers.start(RESPONSE_NANOS, this::giveUpOldest);
        }
    }

    /** @return false for an answer to nothing */
    boolean answered(int sequence, DeliveryOutcome outcome) {
        Outstanding answered = outstanding.remove(sequence);
        if (answered == null) {
            return false;
        }
        answered.receipt.ended(outcome);
        return true;
    }

    private void giveUpOldest() {
        oldest = null;
        List<Outstanding> late = new ArrayList<>();
        Iterator<Outstanding> each = outstanding.values().iterator();
        while (each.hasNext()) {
            Outstanding next = each.next();
            long due = next.sentNanos + RESPONSE_NANOS;
            if (due > timers.nowNanos()) {
                oldest = timers.start(due - timers.nowNanos(), this::giveUpOldest);
                break;
            }
            each.remove();
            late.add(next);
        }
        late.forEach(gone -> gone.receipt.ended(DeliveryOutcome.FAILED));
    }

    /** The session is gone. Returns whom its messages were for. */
    List<Recipient> lose() {
        timers.cancel(oldest);
        List<Outstanding> lost = List.copyOf(outstanding.values());
        outstanding.clear();
        lost.forEach(each -> each.receipt.ended(DeliveryOutcome.ABSENT));
        return lost.stream().map(Outstanding::receiver).distinct().toList();
    }
}
