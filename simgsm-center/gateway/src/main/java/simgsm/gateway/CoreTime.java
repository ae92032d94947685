package simgsm.gateway;

import simgsm.station.StationThread;
import simgsm.timer.Timers;

/** Gives a core its time on the stations' thread. */
final class CoreTime {
    private final StationThread thread;
    private final Timers timers = new Timers();
    private final long originNanos = System.nanoTime();
    /** Time of the earliest pending wake. */
    private long wakeNanos = Long.MAX_VALUE;

    CoreTime(StationThread thread) {
        this.thread = thread;
        timers.onEarlier(this::arm);
    }

    Timers timers() {
        return timers;
    }

    /** Moves the core's time to the present. */
    void advance() {
        timers.advance(System.nanoTime() - originNanos);
    }

    /** Wakes at the next deadline; an earlier pending wake comes first and arms this one. */
    private void arm() {
        long next = timers.nextDeadlineNanos().orElse(Long.MAX_VALUE);
        if (next < wakeNanos) {
            wakeNanos = next;
            thread.after(next - (System.nanoTime() - originNanos), () -> {
                boolean isNewest = wakeNanos == next;
                wakeNanos = isNewest ? Long.MAX_VALUE : wakeNanos;
                advance();
                if (isNewest) {
                    arm();
                }
            });
        }
    }
}
