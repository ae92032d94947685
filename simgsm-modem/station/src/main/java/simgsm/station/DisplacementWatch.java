package simgsm.station;

import java.util.concurrent.TimeUnit;
import simgsm.net.RetryPause;

/**
 * Notices that the centre ends a station's links again and again soon after each registration: another terminal with the same
 * number and IMEI takes its place, and the two would take turns for ever. A core: ends of links and times in, pauses out.
 */
final class DisplacementWatch {
    /** A registration that has lasted 120 s was not displaced; above the longest pause of the other terminal. */
    private static final long SOON_NANOS = TimeUnit.SECONDS.toNanos(120);

    private static final long FIRST_PAUSE_NANOS = TimeUnit.SECONDS.toNanos(2);
    private static final long LONGEST_PAUSE_NANOS = TimeUnit.SECONDS.toNanos(60);
    /** One may be a centre that has been started again; a further one without its absence between them is none. */
    private static final int CERTAIN = 2;

    private final RetryPause pause = new RetryPause(FIRST_PAUSE_NANOS, LONGEST_PAUSE_NANOS);
    private int displacements;

    /**
     * The centre has ended the link of a registered station.
     *
     * @param connectedNanos how long there was a link
     * @return how long to wait at least before the next one
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

    /** Whether the last end of a link is the first that shows another terminal. */
    boolean isNews() {
        return displacements == CERTAIN;
    }
}
