package simgsm.station.sms;

/** Events of {@link IncomingMessageTable}. */
public enum IncomingMessageEvent {
    CP_DATA,
    /** The CP-DATA that has been answered already. */
    CP_DATA_REPEATED,
    CP_ACK,
    CP_ERROR,
    TC1_EXPIRED,
    /** After the last retransmission. */
    TC1_EXPIRED_FINALLY,
    RADIO_LOST
}
