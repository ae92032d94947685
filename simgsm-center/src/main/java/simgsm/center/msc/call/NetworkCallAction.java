package simgsm.center.msc.call;

/** Actions of a call leg on the network side. */
public enum NetworkCallAction {
    SEND_SETUP,
    SEND_CALL_PROCEEDING,
    SEND_ALERTING,
    SEND_CONNECT,
    SEND_CONNECT_ACKNOWLEDGE,
    SEND_DISCONNECT,
    SEND_RELEASE,
    SEND_RELEASE_COMPLETE,
    /** Restarts the timer of the state, which was not left. */
    START_T308,
    /** Plays the network's tone if the message before has announced one. */
    PLAY_TONE,
    // To the call, and through it to the other leg.
    TELL_OFFERED,
    TELL_ALERTING,
    TELL_ANSWERED,
    TELL_ACTIVE,
    TELL_CLEARED
}
