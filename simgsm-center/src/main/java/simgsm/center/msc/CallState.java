package simgsm.center.msc;

/** A call as the operator sees it. */
public enum CallState {
    INITIATED,
    ALERTING,
    ACTIVE,
    RELEASED
}
