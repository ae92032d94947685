package simgsm.station;

enum MobileRegistrationAction {
    LOOK_FOR_CELL,
    SEND_LOCATION_UPDATING_REQUEST,
    TAKE_NEW_IDENTITY,
    FORGET_IDENTITY,
    SEND_IMSI_DETACH,
    RELEASE_CHANNEL,
    /** Waits until the next try: longer after each failure. */
    PAUSE,
    STOP_TIMERS,
    TELL_REGISTERED,
    TELL_UNREGISTERED
}
