package simgsm.station;

import java.util.concurrent.TimeUnit;
import simgsm.net.RetryPause;

/**
 * Detects that the centre repeatedly ends a station's links soon after registration: another terminal with the same
 * number and IMEI replaces it, and the two would alternate for ever. A core: input is ends of links and times, output
 * is pauses.
 */
final class DisplacementWatch {
    /**
     * A registration that has lasted 120 s was not displaced; longer than the longest pause of the other terminal.
     */
    private static final long SOON_NANOS = TimeUnit.SECONDS.toNanos(120);

    private static final long FIRST_PAUSE_NANOS = TimeUnit.SECONDS.toNanos(2);
    private static final long LONGEST_PAUSE_NANOS = TimeUnit.SECONDS.toNanos(60);
    /** One may be a restart of the centre; a second one without its absence is not. */
    private static final int CERTAIN = 2;

    private final RetryPause pause = new RetryPause(FIRST_PAUSE_NANOS, LONGEST_PAUSE_NANOS);
    private int displacements;

    /**
     * The centre has ended the link of a registered station.
     *
     * @param connectedNanos duration of the link
     * @return least pause before the next one
     */
    long linkEnded(long connectedNanos) {
        if (connectedNanos >= SOON_NANOS) {
            reset();
        }
        displacements++;
        return displacements < CERTAIN ? 0 : pause.next();
    }

    /** No centre was found, or the link has ended in another way. */
    void reset() {
        displacements = 0;
        pause.reset();
    }

    /** True if the last end of a link is the first that shows another terminal. */
    boolean isNews() {
        return displacements == CERTAIN;
    }
}
