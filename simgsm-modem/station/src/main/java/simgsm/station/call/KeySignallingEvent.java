package simgsm.station.call;

/** Events of {@link KeySignallingTable}. */
public enum KeySignallingEvent {
    NEXT,
    START_ACKNOWLEDGED,
    START_REJECTED,
    /** The tone has had its length and the key is not held. */
    RELEASED,
    STOP_ACKNOWLEDGED,
    PAUSE_ENDED,
    T336_EXPIRED,
    T337_EXPIRED,
    CALL_ENDED
}
