package simgsm.center.smpp;

/** The connection of a session. */
public interface SmppPort {
    /** Sends a PDU, possibly in one write with others. */
    void send(byte[] pdu);

    /** Closes after all PDUs so far are sent. */
    void closeWhenSent();

    /** Closes at once. */
    void close(String reason);
}
