package simgsm.cells.mobile;

import java.util.ArrayDeque;
import java.util.Deque;
import simgsm.cells.tower.AccessUser;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.tower.FrameClock;
import simgsm.octets.OctetString;
import simgsm.rr.ImmediateAssignment;
import simgsm.rr.RequestReference;
import simgsm.rr.SystemInformation;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** Random access of one mobile (TS 44.018, 3.3.1.1): CHANNEL REQUESTs at random times until an answer. */
final class ChannelRequests implements AccessUser {
    /** Handles an answer. */
    interface Outcome {
        void granted(ImmediateAssignment assignment);

        void failed();
    }

    /** Number of latest requests whose answers count (TS 44.018, 3.3.1.1.3.1). */
    private static final int REMEMBERED = 3;

    private static final SystemInformation.RandomAccess STANDARD = new SystemInformation.RandomAccess(7, 12, false);
    private static final long SECOND_NANOS = 1_000_000_000L;

    private final MobileNetwork network;
    private final Timers timers;
    private final Outcome outcome;
    private final Deque<RequestReference> sent = new ArrayDeque<>();
    private BaseStation tower;

    private int cause;
    private int delay;
    private int left;
    private Timer next;

    ChannelRequests(MobileNetwork network, Timers timers, Outcome outcome) {
        this.network = network;
        this.timers = timers;
        this.outcome = outcome;
    }

    /**
     * Begins.
     *
     * @param firstMessage of layer 3, determines the establishment cause
     * @param delayNanos until the mobile may send
     */
    void begin(BaseStation cell, int timingAdvance, OctetString firstMessage, long delayNanos) {
        end();
        tower = cell;
        cause = EstablishmentCause.of(firstMessage);
        delay = timingAdvance;
        left = 1 + parameters().attempts();
        schedule(delayNanos + spread(parameters().spreadSlots()));
    }

    /** The requested tower; null without an access. */
    BaseStation tower() {
        return tower;
    }

    boolean isUnderWay() {
        return tower != null;
    }

    /** Stops listening. */
    void end() {
        if (tower != null) {
            timers.cancel(next);
            tower.accesses().end(this);
            tower = null;
            sent.clear();
        }
    }

    private SystemInformation.RandomAccess parameters() {
        return tower.cell().map(SystemInformation.Type3::access).orElse(STANDARD);
    }

    private long spread(int slots) {
        return FrameClock.nanos((long) (network.random() * slots));
    }

    private void schedule(long nanos) {
        next = timers.start(nanos, this::request);
    }

    private void request() {
        if (left == 0) {
            outcome.failed();
            return;
        }
        left--;
        int access = cause | (int) (network.random() * EstablishmentCause.randomValues(cause));
        RequestReference reference = tower.accesses().request(access, delay, this);
        sent.add(reference);
        if (sent.size() > REMEMBERED) {
            sent.remove();
        }
        int slots = parameters().spreadSlots();
        schedule(FrameClock.nanos(repetitionSlots(slots)) + spread(slots));
    }

    /** S of TS 44.018, table 3.1, for a control channel without SDCCH; by TX_INTEGER. */
    private static int repetitionSlots(int spreadSlots) {
        return switch (spreadSlots) {
            case 3, 8, 14, 50 -> 55;
            case 4, 9, 16 -> 76;
            case 5, 10, 20 -> 109;
            case 6, 11, 25 -> 163;
            default -> 217;
        };
    }

    @Override
    public void granted(ImmediateAssignment assignment) {
        if (sent.contains(assignment.reference())) {
            outcome.granted(assignment);
        }
    }

    /** Retries after T3122 while the terminal waits. */
    @Override
    public void refused(RequestReference reference, int waitSeconds) {
        if (sent.contains(reference)) {
            timers.cancel(next);
            sent.clear();
            left = 1 + parameters().attempts();
            schedule(waitSeconds * SECOND_NANOS + spread(parameters().spreadSlots()));
        }
    }
}
