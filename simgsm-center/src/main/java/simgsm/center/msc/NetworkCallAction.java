package simgsm.center.msc;

/** What a transition of a call leg makes it do. */
enum NetworkCallAction {
    SEND_SETUP,
    SEND_CALL_PROCEEDING,
    SEND_ALERTING,
    SEND_CONNECT,
    SEND_CONNECT_ACKNOWLEDGE,
    SEND_DISCONNECT,
    SEND_RELEASE,
    SEND_RELEASE_COMPLETE,
    /** The call is told, which tells its other leg. */
    TELL_OFFERED,
    TELL_ALERTING,
    TELL_ANSWERED,
    TELL_ACTIVE,
    TELL_CLEARED
}
