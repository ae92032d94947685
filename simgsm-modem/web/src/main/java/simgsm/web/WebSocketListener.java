package simgsm.web;

/** Receives what a client sends over one WebSocket, on the port's thread. */
public interface WebSocketListener {
    void text(String text);

    void binary(byte[] octets);

    /** The socket has ended for whatever reason; the last call. */
    void closed();
}
