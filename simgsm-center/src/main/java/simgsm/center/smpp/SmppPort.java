package simgsm.center.smpp;

/** The connection of a session. */
public interface SmppPort {
    /** Sends a PDU, possibly in one write with others. */
    void send(byte[] pdu);

    /** The application has proven itself and is bound. */
    default void bound() {}

    /** Closes after all PDUs so far are sent. */
    void closeWhenSent();

    /** Closes at once. */
    void close(String reason);
}
