package simgsm.tone;

import java.util.Optional;

/**
 * The call progress tones (ITU-T E.180; the supervisory tones of TS 22.001, annex F). A {@link ToneSet} has their
 * frequencies and cadences.
 */
public enum ProgressTone {
    /** The exchange waits for digits. Unused by mobiles, which send the whole number at once. */
    DIAL,
    /** The called phone rings. */
    RING_BACK,
    /** The called party is engaged. */
    BUSY,
    /** The network has no free circuit. */
    CONGESTION,
    /** Another call is waiting. */
    CALL_WAITING,
    /** The call cannot be completed as dialled: an announcement would follow. */
    SPECIAL_INFORMATION,
    /** The radio connection was lost during a call. */
    CALL_DROPPED;

    /**
     * The tone of a failed call (TS 22.001, annex F; "special information" for causes that make another try with the
     * same number useless).
     *
     * @param cause decimal, by TS 24.008, table 10.5.123
     */
    public static Optional<ProgressTone> ofCause(int cause) {
        return Optional.ofNullable(
                switch (cause) {
                    case 17 -> BUSY;
                    case 34, 38, 42, 47 -> CONGESTION;
                    case 41 -> CALL_DROPPED;
                    case 1, 22, 27, 28 -> SPECIAL_INFORMATION;
                    default -> null;
                });
    }
}
