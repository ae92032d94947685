package simgsm.phone.store;

import java.time.Instant;
import java.util.Locale;

/**
 * A call in the log.
 *
 * @param number of the other party, empty if unknown
 * @param at time of dialling or of the first ring
 * @param seconds of conversation, 0 if it was never connected
 */
public record CallRecord(Kind kind, String number, Instant at, int seconds) {
    /** The direction of the call. */
    public enum Kind {
        DIALLED,
        /** Taken, or refused by the user. */
        RECEIVED,
        /** The caller gave up. */
        MISSED
    }

    /** mm:ss, from one hour h:mm:ss. */
    public static String duration(int seconds) {
        String tail = String.format(Locale.ROOT, "%02d:%02d", seconds / 60 % 60, seconds % 60);
        return seconds < 3600 ? tail : seconds / 3600 + ":" + tail;
    }
}
