package simgsm.station.sms;

/** SMC and SMR of the mobile for one outgoing message, in one machine (TS 24.011, 5.2 and 6.2). */
public enum OutgoingMessageState {
    IDLE,
    MM_CONNECTION_PENDING,
    WAIT_FOR_CP_ACK,
    /** CP-ACK has arrived, RP-ACK has not. */
    WAIT_FOR_RP_ACK
}
