package simgsm.station.sms;

/** SMC of the mobile for the answer to one incoming message (TS 24.011, 5.2). */
public enum IncomingMessageState {
    IDLE,
    /** CP-DATA with the answer is sent. */
    WAIT_FOR_CP_ACK
}
