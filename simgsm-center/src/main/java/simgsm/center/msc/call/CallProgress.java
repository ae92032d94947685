package simgsm.center.msc.call;

/** State of a call for the operator. */
public enum CallProgress {
    INITIATED,
    ALERTING,
    ACTIVE,
    RELEASED
}
