package simgsm.station;

/** Where the sending of one short message stands: SMC and SMR of the mobile (TS 24.011, 5.2 and 6.2) in one. */
enum OutgoingState {
    IDLE,
    MM_CONNECTION_PENDING,
    WAIT_FOR_CP_ACK,
    /** CP-ACK has come, WAIT FOR RP-ACK. */
    WAIT_FOR_RP_ACK
}
