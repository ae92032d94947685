package simgsm.station.sms;

/** Events of {@link OutgoingMessageTable}. */
public enum OutgoingMessageEvent {
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
    /** No registration in time. */
    WAIT_EXPIRED,
    RADIO_LOST,
    /** The radio connection was lost more often than a message is repeated. */
    RADIO_LOST_FINALLY,
    POWER_OFF
}
