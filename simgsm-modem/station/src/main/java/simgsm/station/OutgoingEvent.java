package simgsm.station;

enum OutgoingEvent {
    SEND,
    MM_CONNECTED,
    MM_REFUSED,
    CP_ACK,
    CP_ERROR,
    RP_ACK,
    RP_ERROR,
    TC1_EXPIRED,
    /** After the last retransmission. */
    TC1_EXPIRED_FINALLY,
    TR1M_EXPIRED,
    /** No service came in time. */
    WAIT_EXPIRED,
    RADIO_LOST,
    /** The radio was lost once too often for this message. */
    RADIO_LOST_FINALLY,
    POWER_OFF
}
