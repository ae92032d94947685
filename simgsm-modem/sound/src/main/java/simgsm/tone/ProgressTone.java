package simgsm.tone;

import java.util.Optional;

/**
 * The call progress tones (ITU-T E.180; the supervisory tones of TS 22.001, annex F). A {@link ToneSet} has their
 * frequencies and cadences.
 */
public enum ProgressTone {
    /** The exchange waits for digits. A mobile needs none: it sends the whole number at once. */
    DIAL,
    /** The called phone rings. */
    RING_BACK,
    /** The called party is engaged. */
    BUSY,
    /** The network has no way free. */
    CONGESTION,
    /** Another call waits. */
    CALL_WAITING,
    /** The call cannot be completed as dialled: an announcement would follow. */
    SPECIAL_INFORMATION,
    /** The radio has been lost in the middle of a call. */
    CALL_DROPPED;

    /**
     * What a caller hears when a call comes to nothing (TS 22.001, annex F; of "special information" the causes for which
     * another try with the same number is of no use).
     *
     * @param cause decimal, as TS 24.008, table 10.5.123 numbers causes
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
