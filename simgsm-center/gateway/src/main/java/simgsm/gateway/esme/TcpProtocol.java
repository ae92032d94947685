package simgsm.gateway.esme;

import java.nio.ByteBuffer;

/** One side of a TCP connection. */
public interface TcpProtocol {
    /** The connection is open; the first call. */
    void connected(TcpSocket socket);

    /** Takes all octets of the buffer. */
    void received(ByteBuffer octets);

    /** The connection could not be opened, or the peer has ended it; the last call. */
    void lost(String reason);
}
