package simgsm.station;

/** What can happen to a call: acts of the user, news of the radio, messages of the network, time. */
enum MobileCallEvent {
    DIAL,
    ANSWER,
    CLEAR,
    POWER_OFF,

    MM_CONNECTED,
    MM_REFUSED,
    RADIO_LOST,

    SETUP,
    /** A call that has waited, alerted already, becomes the call. */
    TAKE_WAITING,
    /** The offered call is one that we can take: one for speech, as all are. */
    COMPATIBLE,
    /** The user hears the ringing. */
    USER_ALERTED,
    CALL_PROCEEDING,
    PROGRESS,
    ALERTING,
    CONNECT,
    CONNECT_ACKNOWLEDGE,
    DISCONNECT,
    /** The network's DISCONNECT carries no tones that we should listen to: the call can be released. */
    NOTHING_TO_HEAR,
    /** It does: they are heard first. */
    TONES_TO_HEAR,
    RELEASE,
    RELEASE_COMPLETE,
    /** STATUS says that the network knows of no call. */
    STATUS_NULL,

    T303_EXPIRED,
    T305_EXPIRED,
    T308_EXPIRED,
    /** The second time. */
    T308_EXPIRED_AGAIN,
    T310_EXPIRED,
    T313_EXPIRED
}
