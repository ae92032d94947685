package simgsm.station;

enum OutgoingAction {
    REQUEST_CONNECTION,
    RELEASE_CONNECTION,
    /** The present connection is done with; a request for the next one stands. */
    END_CONNECTION,
    SEND_CP_DATA,
    SEND_CP_ACK,
    START_WAIT,
    START_TC1,
    START_TR1M,
    STOP_TC1,
    STOP_TIMERS,
    /** From now on the network may have the message: a repetition says so (TP-RD). */
    MARK_REPEATED,
    TELL_SENT,
    TELL_FAILED,
    SEND_NEXT
}
