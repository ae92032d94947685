package simrobot.p2os;

/** Where a session's answers go. */
public interface PacketOutput {
    /** Takes a whole packet, frame and all; one that the client is too slow for may be lost, as on the real line. */
    void send(byte[] packet);

    /** Ends the connection; what was sent before leaves first, as far as the client takes it. */
    void close();
}
