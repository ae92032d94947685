package simgsm.center.smpp;

/** A session's way out, to whatever carries its octets. */
public interface SmppPort {
    /** Takes a whole PDU; it may wait for others and go out together with them. */
    void send(byte[] pdu);

    /** Closes once everything taken before has gone. */
    void closeWhenSent();

    /** Closes at once. */
    void close(String reason);
}
