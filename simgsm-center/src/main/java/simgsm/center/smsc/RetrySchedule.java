package simgsm.center.smsc;

import java.time.Duration;
import java.util.List;

/**
 * Pauses between the attempts to reach a mobile, one schedule for all its waiting messages; for an application, between
 * the attempts at one message.
 */
public final class RetrySchedule {
    /** The pauses after 1, 2, 3 ... successive failures; the last one repeats. */
    public static final List<Duration> PAUSES = List.of(
            Duration.ofMinutes(1),
            Duration.ofMinutes(5),
            Duration.ofMinutes(10),
            Duration.ofMinutes(30),
            Duration.ofHours(1),
            Duration.ofHours(3),
            Duration.ofHours(6),
            Duration.ofHours(12));

    /** Doublings for a busy application: 1, 2, 4 ... 32 s, then the pause of a first failure. */
    private static final int MOST_DOUBLINGS = 6;

    private RetrySchedule() {}

    /** @param failures in succession, at least 1 */
    static Duration pauseAfter(int failures) {
        return PAUSES.get(Math.min(failures, PAUSES.size()) - 1);
    }

    /** @param refusals in succession, at least 1 */
    public static Duration pauseWhenBusy(int refusals) {
        Duration doubled = Duration.ofSeconds(1L << Math.min(refusals - 1, MOST_DOUBLINGS));
        return doubled.compareTo(PAUSES.get(0)) < 0 ? doubled : PAUSES.get(0);
    }
}
