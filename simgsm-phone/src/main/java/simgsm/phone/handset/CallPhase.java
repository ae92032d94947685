package simgsm.phone.handset;

/** The call as its user sees it. */
public enum CallPhase {
    NONE,
    /** One's own call, on its way. */
    CALLING,
    /** The other phone rings. */
    ALERTING,
    /** Somebody calls. */
    RINGING,
    CONNECTED
}
