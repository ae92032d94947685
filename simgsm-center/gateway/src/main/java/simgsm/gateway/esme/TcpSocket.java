package simgsm.gateway.esme;

/** An open TCP connection, as the cores of this package see it. */
public interface TcpSocket {
    void send(byte[] octets);

    /** Closes the connection once all octets are written; its protocol hears nothing more. */
    void closeWhenSent();
}
