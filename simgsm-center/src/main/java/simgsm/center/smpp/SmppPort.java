package simgsm.center.smpp;

/** The connection of a session. */
public interface SmppPort {
    /** Sends a PDU, possibly in one write with others. */
    void send(byte[] pdu);

    /** The application is authenticated and bound. */
    default void bound() {}

    /** Closes after sending all PDUs so far. */
    void closeWhenSent();

    /** Closes at once. */
    void close(String reason);
}
