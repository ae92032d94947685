package simrobot.p2os;

/** Output of a session's packets. */
public interface PacketOutput {
    /** Sends a framed packet; it may be dropped if the client reads too slowly, as on a serial line. */
    void send(byte[] packet);

    /** Closes the connection after the packets already sent, if the client reads them. */
    void close();
}
