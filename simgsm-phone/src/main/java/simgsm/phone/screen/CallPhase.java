package simgsm.phone.screen;

/** The phases of a call as seen by its user. */
public enum CallPhase {
    NONE,
    /** Originated here, not yet ringing at the far end. */
    CALLING,
    /** The called phone rings. */
    ALERTING,
    /** An incoming call. */
    RINGING,
    CONNECTED
}
