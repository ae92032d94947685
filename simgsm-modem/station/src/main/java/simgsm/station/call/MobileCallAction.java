package simgsm.station.call;

/** What {@link MobileCall} does on a transition. */
public enum MobileCallAction {
    REQUEST_CONNECTION,
    RELEASE_CONNECTION,
    SEND_SETUP,
    SEND_CALL_CONFIRMED,
    SEND_ALERTING,
    SEND_CONNECT,
    SEND_CONNECT_ACKNOWLEDGE,
    SEND_DISCONNECT,
    SEND_RELEASE,
    SEND_RELEASE_COMPLETE,
    START_T303,
    START_T305,
    START_T308,
    START_T308_AGAIN,
    START_T310,
    START_T313,
    STOP_TIMERS,
    /** If the message announces tones of the network, opens the speech path for them (5.5.1). */
    ATTACH_USER,
    START_SPEECH,
    STOP_SPEECH,
    REPORT_CALLING,
    REPORT_ALERTED,
    REPORT_RINGING,
    REPORT_CONNECTED,
    REPORT_HELD,
    REPORT_RETRIEVED,
    REPORT_RELEASED,
    CHECK_COMPATIBILITY,
    ALERT_USER,
    /** Fires TONES_ANNOUNCED or NO_TONES_ANNOUNCED. */
    CHECK_TONES
}
