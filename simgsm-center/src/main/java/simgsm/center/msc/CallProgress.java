package simgsm.center.msc;

/** A call as the operator sees it. */
public enum CallProgress {
    INITIATED,
    ALERTING,
    ACTIVE,
    RELEASED
}
