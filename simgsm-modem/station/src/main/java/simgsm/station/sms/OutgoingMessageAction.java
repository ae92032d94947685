package simgsm.station.sms;

/** What {@link MessageSender} does on a transition. */
public enum OutgoingMessageAction {
    REQUEST_CONNECTION,
    RELEASE_CONNECTION,
    /** Ends the current connection; a request for the next one stays. */
    COMPLETE_CONNECTION,
    SEND_CP_DATA,
    SEND_CP_ACK,
    START_WAIT,
    START_TC1,
    START_TR1M,
    STOP_TC1,
    STOP_TIMERS,
    /** The network may have the message: a repetition is marked (TP-RD). */
    MARK_REPEATED,
    REPORT_SENT,
    REPORT_FAILED,
    SEND_NEXT
}
