package simgsm.station.mobility;

/** What {@link MobileRegistration} does on a transition. */
public enum MobileRegistrationAction {
    SEARCH_CELL,
    SEND_LOCATION_UPDATING_REQUEST,
    TAKE_NEW_IDENTITY,
    FORGET_IDENTITY,
    SEND_IMSI_DETACH,
    RELEASE_CHANNEL,
    /** Waits before the next attempt, longer after each failure. */
    PAUSE,
    STOP_TIMERS,
    REPORT_REGISTERED,
    REPORT_UNREGISTERED
}
