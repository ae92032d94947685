package simgsm.web;

import java.net.InetAddress;

/** The server's end of one WebSocket; belongs to the port's thread. */
public interface WebSocket {
    /** Data that cannot be accepted, for {@link #close}. */
    int UNSUPPORTED_DATA = 1003;

    void send(String text);

    /** Sends a binary message. Of those that the client does not take, all but the newest 10 are dropped. */
    void send(byte[] octets);

    /** Ends the socket; later input is dropped. @param reason at most 123 octets in UTF-8 */
    void close(int code, String reason);

    /** True while sent messages wait for the client to take them. */
    boolean hasOutput();

    /** The client's address. */
    InetAddress peer();

    /** True if the request had no origin, or that of a page of this machine. */
    boolean isLocalPage();
}
