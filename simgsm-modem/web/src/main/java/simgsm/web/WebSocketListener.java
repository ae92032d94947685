package simgsm.web;

/** Receives a client's messages over one WebSocket, on the port's thread. */
public interface WebSocketListener {
    void text(String text);

    void binary(byte[] octets);

    /** The socket has ended for any reason; the last call. */
    void closed();
}
