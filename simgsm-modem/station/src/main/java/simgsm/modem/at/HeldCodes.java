package simgsm.modem.at;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * Unsolicited codes that wait for the end of a command line, or after an announcement until 500 ms have passed
 * without a command: clients read an announced message at once, and would take a code received meanwhile for the
 * answer.
 */
final class HeldCodes {
    /** If more codes wait, the oldest is dropped. */
    static final int MAX_HELD = 256;

    static final long ANNOUNCED_NANOS = TimeUnit.MILLISECONDS.toNanos(500);
    static final long MOST_ANNOUNCED_NANOS = TimeUnit.SECONDS.toNanos(2);

    /** @param isAnnouncement true if a command is expected to follow */
    private record Code(String octets, boolean isAnnouncement) {}

    private final Timers timers;
    private final Consumer<String> output;
    private final Runnable due;
    private final Deque<Code> held = new ArrayDeque<>();
    private Timer afterAnnouncement;
    private long latestAnnouncedNanos;

    /** @param due runs when no command has followed an announcement */
    HeldCodes(Timers timers, Consumer<String> output, Runnable due) {
        this.timers = timers;
        this.output = output;
        this.due = due;
    }

    void add(String octets, boolean isAnnouncement) {
        if (held.size() == MAX_HELD) {
            held.remove();
        }
        held.add(new Code(octets, isAnnouncement));
    }

    /** Sends all codes, up to an announcement. */
    void send() {
        while (!held.isEmpty() && !isAwaitingCommand()) {
            Code code = held.remove();
            output.accept(code.octets());
            if (code.isAnnouncement()) {
                latestAnnouncedNanos = timers.nowNanos() + MOST_ANNOUNCED_NANOS;
                awaitCommand();
            }
        }
    }

    /** Another command may follow. */
    void commandEnded() {
        if (isAwaitingCommand()) {
            awaitCommand();
        }
        send();
    }

    void close() {
        timers.cancel(afterAnnouncement);
    }

    private void awaitCommand() {
        timers.cancel(afterAnnouncement);
        long mostNanos = latestAnnouncedNanos - timers.nowNanos();
        if (mostNanos > 0) {
            afterAnnouncement = timers.start(Math.min(ANNOUNCED_NANOS, mostNanos), due);
        }
    }

    private boolean isAwaitingCommand() {
        return afterAnnouncement != null && afterAnnouncement.isRunning();
    }
}
