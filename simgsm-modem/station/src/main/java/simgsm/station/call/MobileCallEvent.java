package simgsm.station.call;

/** Events of {@link MobileCallTable}: commands of the user, the radio connection, messages of the network, timers. */
public enum MobileCallEvent {
    DIAL,
    ANSWER,
    CLEAR,
    POWER_OFF,

    MM_CONNECTED,
    MM_REFUSED,
    RADIO_LOST,

    SETUP,
    /** A waiting call, already alerted, becomes the call. */
    TAKE_WAITING,
    /** A waiting call becomes the call and is answered at once. */
    ANSWER_WAITING,
    /** The network holds the active call: another one may be the current one now. */
    CALL_HELD,
    /** The network gives the held call back. */
    CALL_RETRIEVED,
    /** The offered call is for speech, as all are here. */
    COMPATIBLE,
    /** The terminal rings. */
    USER_ALERTED,
    CALL_PROCEEDING,
    PROGRESS,
    ALERTING,
    CONNECT,
    CONNECT_ACKNOWLEDGE,
    DISCONNECT,
    /** DISCONNECT without in-band tones: the call is released at once. */
    NO_TONES_ANNOUNCED,
    /** DISCONNECT with in-band tones: they are heard first. */
    TONES_ANNOUNCED,
    RELEASE,
    RELEASE_COMPLETE,
    /** STATUS: the network is in state N0. */
    STATUS_NULL,

    T303_EXPIRED,
    T305_EXPIRED,
    T308_EXPIRED,
    /** The second time. */
    T308_EXPIRED_AGAIN,
    T310_EXPIRED,
    T313_EXPIRED
}
